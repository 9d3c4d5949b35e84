# restitution.gp OUTPUT FILE: stated against true restitution, for every law that sets the damping at each impact.
output = ARG1; file = ARG2
load 'style.gp'
set xlabel 'stated restitution'
set ylabel 'restitution that comes out'
set xrange [0:1]
set yrange [0:1]
set size square
set key bottom right
dampings = 'exact hu-guo flores hunt-crossley herbert-mcwhannell lankarani-nikravesh lee-wang'
colours = 'black #0072B2 #56B4E9 #D55E00 #E69F00 #009E73 #CC79A7'
dashes = '1 2 4 1 2 4 1'
plot for [i = 1:words(dampings)] file using (strcol(1) eq word(dampings, i) ? $2 : NaN):(($3 + $4) / 2) skip 1 \
  with lines linewidth 2 linecolor rgb word(colours, i) dashtype int(word(dashes, i)) title word(dampings, i)
