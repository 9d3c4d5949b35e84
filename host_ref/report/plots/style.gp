# Shared by every picture. Black and gray are ink and grid: the page's style sheet turns them for dark screens. The others
# are Okabe and Ito's colours, which colour-blind readers tell apart; dash and marker differ as well.
# `output` names the file.
set terminal svg size 520,430 dynamic font 'sans-serif,14' noenhanced
set output output
set encoding utf8
set datafile separator comma
set datafile missing NaN
set border 3 linecolor rgb 'black'
set tics nomirror
set grid linecolor rgb 'gray' linetype 1 linewidth 0.4

methods = 'moment moment-4 energy impulsive average linear fox-goodwin central textbook-newmark textbook-newmark-sqrt textbook-rk4 textbook-rk4-sqrt textbook-rk4-lookup tuned-rk4'
colours = '#0072B2 #56B4E9 #D55E00 #009E73 #E69F00 #CC79A7 #009E73 #56B4E9 black black #808080 #808080 #808080 #D55E00'
dashes = '1 1 1 1 2 3 4 5 1 2 1 2 3 2'
numerics = 'fixed32 float32 float32-plain float64'
markers = '5 6 8 1'
laws = 'hooke-newton hertz hunt-crossley'
