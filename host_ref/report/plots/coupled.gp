# coupled.gp OUTPUT FILE: the largest energy gain in random coupled scenes, by stepper, law and format. A stepper has a
# column for each format, in the order of `formats`.
output = ARG1; file = ARG2
load 'style.gp'
set terminal svg size 720,430 dynamic font 'sans-serif,14' noenhanced
set logscale y
set format y '%g'
set ylabel 'largest relative energy gain'
set yrange [1e-16:1e3]  # what is beyond stands at the edge
steppers = 'auto moment moment-4 moment-8 energy impulsive average'
formats = 'float64 float32 float32-plain fixed32'
of(words_, name) = sum [i = 1:words(words_)] (word(words_, i) eq name ? i : 0)
place(x) = of(steppers, strcol(2)) + 0.2 * (of(formats, strcol(3)) - 2.5)
set xrange [0.5:words(steppers) + 0.5]
set xtics scale 0
do for [i = 1:words(steppers)] { set xtics add (word(steppers, i) i) }
do for [i = 1:words(steppers) - 1] { set arrow from i + 0.5, graph 0 to i + 0.5, graph 1 nohead linecolor rgb 'gray' linewidth 0.8 }
unset grid
set grid ytics linecolor rgb 'gray' linetype 1 linewidth 0.4
set key below center maxrows 1 samplen 1.5
shown(x) = x <= 1e-16 ? 1e-16 : x <= 1e3 ? x : 1e3
gain(x) = strcol(6) eq 'inf' || strcol(6) eq 'nan' ? 1e3 : shown(column(6))
colour(law) = law eq 'hooke-newton' ? '#E69F00' : law eq 'hertz' ? '#009E73' : '#0072B2'
marker(law) = law eq 'hooke-newton' ? 8 : law eq 'hertz' ? 4 : 7
aside(law) = law eq 'hooke-newton' ? -0.05 : law eq 'hertz' ? 0 : 0.05
says(x) = sprintf('%s, %s in %s · %s scenes, %s faults · energy gain %s', strcol(1), strcol(2), strcol(3), strcol(4), strcol(5), strcol(6))
set arrow from graph 0, first 1e-2 to graph 1, first 1e-2 nohead linecolor rgb 'black' dashtype 2 linewidth 0.6
plot for [l in laws] file using (strcol(1) eq l ? place(0) + aside(l) : NaN):(gain(0)) skip 1 with points pointsize 0.8 pointtype marker(l) \
    linecolor rgb colour(l) title l, \
  file using (place(0) + aside(strcol(1))):(gain(0)):(says(0)) skip 1 with labels hypertext noenhanced point pointtype 6 pointsize 1.4 notitle
