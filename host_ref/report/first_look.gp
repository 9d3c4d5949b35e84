# first_look.gp OUTPUT RUNS: the main mass without absorber, and with Hunt-Crossley contact.
output = ARG1; file = ARG2
set terminal svg size 900,430 dynamic font 'sans-serif,15' noenhanced background rgb 'white'
set output output
set encoding utf8
set datafile separator comma
set datafile missing NaN
set border 3 linecolor rgb 'black'
set tics nomirror
set grid linecolor rgb 'gray' linetype 1 linewidth 0.4
set xlabel 'time, s'
set ylabel 'displacement of the main mass, mm'
set key below center maxrows 1
of(run) = $1 == run ? $3 * 1e-6 : NaN
plot file using ($2 * 1e-4):(of(0)) skip 1 with lines linewidth 1 linecolor rgb '#808080' title 'without absorber', \
     '' using ($2 * 1e-4):(of(3)) skip 1 with lines linewidth 1.8 linecolor rgb '#0072B2' title 'with absorber, Hunt-Crossley'
