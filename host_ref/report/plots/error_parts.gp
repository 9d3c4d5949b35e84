# error_parts.gp OUTPUT ACCURACY LAW: the method's error and rounding's against the step length.
output = ARG1; file = ARG2; law = ARG3
load 'style.gp'
set logscale xy
set format '10^{%T}'
set terminal svg size 520,560 dynamic font 'sans-serif,14' enhanced
set xlabel 'step, s' offset 0,0.3
set ylabel 'largest error of x1 over 1 s, m'
set key below center width -2 maxcols 2 samplen 2.5 font ',12' noenhanced height 1
set xrange [1e-5:1e-2]
set yrange [1e-12:1e-1]
shown = 'moment average'
pick(m, f) = strcol(1) eq law && strcol(2) eq m && strcol(3) eq f ? column(4) : NaN
colour(m) = m eq 'moment' ? '#0072B2' : '#E69F00'
plot for [m in shown] file using (pick(m, 'float64')):6 skip 1 with lines linewidth 2.4 linecolor rgb colour(m) title m . ': method', \
     for [m in shown] for [j = 1:3] file using (pick(m, word(numerics, j))):7 skip 1 \
       with linespoints linewidth 1 dashtype 2 pointsize 0.6 pointtype int(word(markers, j)) linecolor rgb colour(m) \
       title m . ': rounding, ' . word(numerics, j)
