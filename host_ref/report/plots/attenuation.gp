# attenuation.gp OUTPUT FILE: what the ball takes of the vibration, by rig and friction, over the drive's pulsation.
output = ARG1; file = ARG2
load 'style.gp'
set terminal svg size 540,430 dynamic font 'sans-serif,14' noenhanced
set xlabel 'pulsation of the drive, rad/s' offset 0,0.4
set ylabel 'attenuation, %'
set key below center maxrows 2 samplen 3 height 0.5
set yrange [-100:100]  # what is beyond stands at the edge
set arrow from graph 0, first 0 to graph 1, first 0 nohead linecolor rgb 'black' linewidth 0.8
of(rig, rubs) = strcol(1) eq rig && ($2 > 0) == rubs ? (column(6) > -1 ? 100*column(6) : -100) : NaN
says(x) = sprintf('%s, friction %s N · %s rad/s · swing %.1f mm, %.1f without the ball · attenuation %.0f %%', strcol(1), strcol(2), strcol(3), 1e3*column(5), 1e3*column(4), 100*column(6))
plot file using 3:(of('level', 0)) skip 1 with lines linewidth 2.4 linecolor rgb '#0072B2' title 'level', \
     '' using 3:(of('level', 1)) skip 1 with lines linewidth 2.4 dashtype 2 linecolor rgb '#56B4E9' title 'level, friction', \
     '' using 3:(of('upright', 0)) skip 1 with lines linewidth 2.4 linecolor rgb '#D55E00' title 'upright', \
     '' using 3:(of('upright', 1)) skip 1 with lines linewidth 2.4 dashtype 2 linecolor rgb '#E69F00' title 'upright, friction', \
     '' using 3:(column(6) > -1 ? 100*column(6) : -100):(says(0)) skip 1 with labels hypertext noenhanced point pointtype 6 pointsize 1.4 notitle
