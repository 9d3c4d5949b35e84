# frontier.gp OUTPUT FILE COST: error against cost of the kernel's best, the best baseline and the paper's scheme.
# FILE has rows series,cost,error_m,text; each point shows its text.
output = ARG1; file = ARG2; what = ARG3
load 'style.gp'
set logscale xy
set format '10^{%T}'
set terminal svg size 500,410 dynamic font 'sans-serif,14' enhanced
set xlabel what . ' per simulated second' offset 0,0.3 noenhanced
set ylabel 'largest error of x1 over 1 s, m'
set key above center maxrows 2 samplen 1.6 height 0.5
set yrange [what eq 'nanoseconds' ? 1e-16 : 1e-10 : 1e-1]  # the host has double
pick(s) = strcol(1) eq s ? column(3) : NaN
set offsets graph 0.03, graph 0.03, 0, 0
plot file using 2:(pick('kernel')) skip 1 with linespoints linewidth 3 pointtype 5 pointsize 0.8 linecolor rgb '#0072B2' title 'kernel', \
     '' using 2:(pick('baseline')) skip 1 with linespoints linewidth 2 dashtype 2 pointtype 7 pointsize 0.8 linecolor rgb '#D55E00' title 'best baseline', \
     '' using 2:(pick('paper')) skip 1 with linespoints linewidth 2 dashtype 4 pointtype 9 pointsize 0.9 linecolor rgb '#E69F00' title "paper's scheme", \
     '' using 2:3:4 skip 1 with labels hypertext noenhanced point pointtype 6 pointsize 1.6 notitle
