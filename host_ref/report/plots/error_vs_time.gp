# error_vs_time.gp OUTPUT FILE LAW TARGET: error against cost. TARGET is one of FILE's, or `host` for nanoseconds.
output = ARG1; file = ARG2; law = ARG3; target = ARG4
load 'style.gp'
host = target eq 'host'
set format x '10^{%T}'
set format y '10^{%T}'
set terminal svg size 560,620 dynamic font 'sans-serif,14' enhanced
set xlabel host ? 'nanoseconds per simulated second, this host' : 'instructions per simulated second, ' . target
set ylabel 'largest error of x1 over 1 s, m'
set key below center maxcols 2 samplen 2.5 width -2 font ',12' noenhanced height 1
set xlabel offset 0,0.3

series(m, f) = host ? strcol(1) eq law && strcol(2) eq m && strcol(3) eq f \
                    : strcol(1) eq target && strcol(2) eq law && strcol(3) eq m && strcol(4) eq f
has(m, f) = system(sprintf('grep -c "^%s%s,%s,%s," "%s"', host ? '' : target . ',', law, m, f, file)) + 0 > 0
cost(x) = host ? column(8) / column(4) : column(7)
error(x) = host ? column(5) : column(6)
frontier(x) = host ? 0 : strcol(1) eq target && strcol(2) eq law && column(8) == 1

command = host ? 'plot NaN notitle' : \
  'plot file using (frontier(0) ? cost(0) : NaN):(error(0)) skip 1 smooth unique with lines linewidth 9 linecolor rgb "gray" title "frontier"'
do for [i = 1:words(methods)] {
  m = word(methods, i); is_present = 0
  do for [j = 1:words(numerics)] {
    f = word(numerics, j)
    if (has(m, f)) {
      is_present = 1
      command = command . sprintf(', file using (series("%s", "%s") ? cost(0) : NaN):(error(0)) skip 1 with linespoints linewidth %s dashtype %s linecolor rgb "%s" pointtype %s pointsize 0.6 notitle', \
        m, f, m eq 'moment' ? '2.4' : '1.2', word(dashes, i), word(colours, i), word(markers, j))
    }
  }
  if (is_present) { command = command . sprintf(', keyentry with lines linewidth 2.4 dashtype %s linecolor rgb "%s" title "%s"', word(dashes, i), word(colours, i), m) }
}
do for [j = 1:words(numerics)] {
  f = word(numerics, j)
  if (has('[^,]*', f)) { command = command . sprintf(', keyentry with points pointtype %s linecolor rgb "black" title "%s"', word(markers, j), f) }
}
m_of(x) = host ? strcol(2) : strcol(3); f_of(x) = host ? strcol(3) : strcol(4); step_of(x) = host ? strcol(4) : strcol(5)
here(x) = host ? strcol(1) eq law : strcol(1) eq target && strcol(2) eq law
says(x) = sprintf('%s in %s · step %s s · error %.2g m · %.3g %s per simulated second', \
  m_of(0), f_of(0), step_of(0), error(0), cost(0), host ? 'ns' : 'instructions')
command = command . ', file using (here(0) ? cost(0) : NaN):(error(0)):(says(0)) skip 1 with labels hypertext noenhanced point pointtype 6 pointsize 1.2 notitle'
set logscale xy
set yrange [host ? 1e-16 : 1e-10 : 1e-1]
eval command
