# coupled.gp OUTPUT FILE: the largest energy gain in random coupled scenes, by stepper, format and law.
output = ARG1; file = ARG2
load 'style.gp'
set terminal svg size 720,430 dynamic font 'sans-serif,14' noenhanced
set logscale y
set format y '%g'
set ylabel 'largest relative energy gain'
set yrange [1e-16:1e3]  # what is beyond stands at the edge
set offsets 0.5, 0.8, 0, 0
set xtics rotate by -35 left
set key below center maxrows 1 samplen 1.5
set rmargin 10
shown(x) = x <= 1e-16 ? 1e-16 : x <= 1e3 ? x : 1e3
gain(x) = strcol(6) eq 'inf' || strcol(6) eq 'nan' ? 1e3 : shown(column(6))
colour(law) = law eq 'hooke-newton' ? '#E69F00' : law eq 'hertz' ? '#009E73' : '#0072B2'
marker(law) = law eq 'hooke-newton' ? 8 : law eq 'hertz' ? 4 : 7
says(x) = sprintf('%s, %s in %s · %s scenes, %s faults · energy gain %s', strcol(1), strcol(2), strcol(3), strcol(4), strcol(5), strcol(6))
set arrow from graph 0, first 1e-5 to graph 1, first 1e-5 nohead linecolor rgb 'black' dashtype 2 linewidth 0.6
plot file using 0:(gain(0)):xtic(strcol(2) . ', ' . strcol(3)) skip 1 with points pointsize 0 linecolor rgb 'gray' notitle, \
  for [l in laws] file using (strcol(1) eq l ? $0 : NaN):(gain(0)) skip 1 with points pointsize 0.9 pointtype marker(l) \
    linecolor rgb colour(l) title l, \
  file using 0:(gain(0)):(says(0)) skip 1 with labels hypertext noenhanced point pointtype 6 pointsize 1.4 notitle
