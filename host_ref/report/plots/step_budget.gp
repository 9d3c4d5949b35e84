# step_budget.gp OUTPUT FILE: worst step of the moment-fitted kernel on each part, against the period. FILE has rows
# position,part,law,numeric,microseconds,text.
output = ARG1; file = ARG2
load 'style.gp'
set terminal svg size 520,560 dynamic font 'sans-serif,14' noenhanced
set logscale y
set ylabel 'worst step, microseconds'
set yrange [0.2:3000]
set rmargin 8
set xrange [0.5:7.5]
set xtics rotate by -25 left font ',12'
set key below center maxcols 1 samplen 1.5 width -2 font ',12'
do for [rate in '1 10 50'] {
  set arrow from 0.5, 1000.0 / rate to 7.5, 1000.0 / rate nohead linecolor rgb 'black' dashtype 2 linewidth 0.6
  set label sprintf('%s kHz', rate) at 7.6, 1000.0 / rate left font ',12'
}
colour(law) = law eq 'hooke-newton' ? '#E69F00' : law eq 'hertz' ? '#009E73' : '#0072B2'
shift(law) = law eq 'hooke-newton' ? -0.2 : law eq 'hertz' ? 0 : 0.2
pick(l, f) = strcol(3) eq l && strcol(4) eq f ? column(1) + shift(l) : NaN
plot file using 1:5:xtic(2) skip 1 with points pointsize 0 linecolor rgb 'gray' notitle, \
  for [l in laws] for [j = 1:3] file using (pick(l, word(numerics, j))):5 skip 1 with points pointsize 0.8 \
    pointtype int(word(markers, j)) linecolor rgb colour(l) title l . ', ' . word(numerics, j), \
  for [l in laws] for [j = 1:3] file using (pick(l, word(numerics, j))):5:6 skip 1 \
    with labels hypertext noenhanced point pointtype 6 pointsize 1.2 notitle
