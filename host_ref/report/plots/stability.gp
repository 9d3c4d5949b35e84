# stability.gp FOLDER FILE: for every law, stepper and number format a map of step against contact stiffness. Colour is the
# restitution's error, a cross says that energy is created, and what the plan refuses is faded.
folder = ARG1; file = ARG2
output = '/dev/null'
load 'style.gp'
set terminal svg size 400,330 dynamic font 'sans-serif,15' enhanced
set logscale xy
set format '10^{%T}'
set xlabel 'step, s' offset 0,0.5
set ylabel 'contact stiffness' offset 1
set xrange [7.5e-6:1.33e-2]
set yrange [5.6e2:1.78e12]
set ytics 100
set tics scale 0
unset grid
unset key
unset colorbox
set palette defined (0 '#deebf7', 1 '#9ecae1', 2 '#4292c6', 3 '#fdae61', 4 '#b2182b')
set cbrange [0:4]
class(e) = e <= 1e-4 ? 0 : e <= 1e-3 ? 1 : e <= 1e-2 ? 2 : e <= 1e-1 ? 3 : 4
larger(a, b) = a > b ? a : b
error(x) = larger(abs(column(6) - column(8)), abs(column(7) - column(8)))
is_shown(x) = strcol(1) eq law && strcol(2) eq stepper && strcol(3) eq numeric
refused(x) = is_shown(0) && column(10) == 0
gains(x) = is_shown(0) && column(9) > 1e-3
step(is_wanted) = is_wanted ? column(4) : 1e-9  # or out of sight
says(x) = sprintf('step %.3g s · stiffness %.2g · restitution %s to %s, exact %s · energy gain %s', \
  column(4), column(5), strcol(6), strcol(7), strcol(8), strcol(9))
first(x) = is_shown(0) && law eq 'hunt-crossley' && numeric eq 'float64' && strstrt('auto average textbook-rk4', stepper) > 0
width = 10**0.125; height = 10**0.25

do for [law in laws] { do for [stepper in 'auto ' . methods] { do for [numeric in 'float64 fixed32'] {
  if (system(sprintf('grep -c "^%s,%s,%s," "%s"', law, stepper, numeric, file)) + 0 > 0) {
    set output sprintf('%s/stability_%s_%s_%s.svg', folder, law, stepper, numeric)
    set title stepper . ', ' . numeric noenhanced offset 0,-0.6
    plot file using (is_shown(0) ? $4 : NaN):5:($4 / width):($4 * width):($5 / height):($5 * height):(class(error(0))) skip 1 \
           with boxxyerror fillstyle solid noborder linecolor palette, \
         '' using (step(gains(0))):5 skip 1 with points pointtype 2 pointsize 0.6 linewidth 1.5 linecolor rgb '#111111', \
         '' using (step(refused(0))):5:(step(refused(0)) / width):(step(refused(0)) * width):($5 / height):($5 * height) skip 1 \
           with boxxyerror fillstyle transparent solid 0.6 noborder linecolor rgb 'white', \
         '' using (step(first(0))):5:(says(0)) skip 1 with labels hypertext noenhanced point pointtype 4 pointsize 1.2
  }
} } }
