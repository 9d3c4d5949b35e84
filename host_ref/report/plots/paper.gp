# paper.gp OUTPUT TRACES RESTITUTIONS FIGURE: the paper's figure 2, 4, 6, 7, 8, 9 or 10.
output = ARG1; traces = ARG2; restitutions = ARG3; figure = int(ARG4)
load 'style.gp'
set key below center maxcols 2 samplen 2.5 width -2 font ',12' height 1
set xlabel 'time, s' offset 0,0.3
ink = 'black'; hn = '#E69F00'; hz = '#009E73'; hc = '#0072B2'; reference = '#D55E00'
if (figure == 2 || figure == 4 || figure == 6) {
  law = figure == 2 ? 'hooke-newton' : figure == 4 ? 'hertz' : 'hunt-crossley'
  set ylabel 'displacement of the main mass, mm'
  plot traces using 't':'without-absorber x1' with lines linewidth 0.8 linecolor rgb '#808080' title 'without absorber', \
       '' using 't':law . ' x1' with lines linewidth 1.8 linecolor rgb hc title law . ', kernel', \
       '' using 't':law . ' x1 reference' with lines linewidth 1 dashtype 2 linecolor rgb reference title law . ', reference'
}
if (figure == 7) {
  set ylabel 'displacement of the main mass, mm'
  plot traces using 't':'hertz x1' with lines linewidth 1 dashtype 3 linecolor rgb hz title 'hertz', \
       '' using 't':'hooke-newton x1' with lines linewidth 1.2 dashtype 2 linecolor rgb hn title 'hooke-newton', \
       '' using 't':'hunt-crossley x1' with lines linewidth 1.6 linecolor rgb hc title 'hunt-crossley'
}
if (figure == 8) {
  set xlabel 'coefficient of restitution' offset 0,0.3
  set ylabel 'largest displacement in 5 s, mm'
  set yrange [0:]
  plot restitutions using 1:6 with linespoints dashtype 3 pointtype 8 linecolor rgb hz title 'hertz', \
       '' using 1:7 with lines linecolor rgb hz linewidth 0.9 title 'hertz, reference', \
       '' using 1:2 with linespoints dashtype 2 pointtype 4 linecolor rgb hn title 'hooke-newton', \
       '' using 1:3 with lines linecolor rgb hn linewidth 0.9 title 'hooke-newton, reference', \
       '' using 1:4 with linespoints linewidth 1.6 pointtype 6 linecolor rgb hc title 'hunt-crossley', \
       '' using 1:5 with lines linecolor rgb hc linewidth 0.9 title 'hunt-crossley, reference'
}
if (figure == 9) {
  set ylabel 'attenuation of the peak so far, %'
  plot traces using 't':'hertz attenuation' with lines dashtype 3 linecolor rgb hz title 'hertz', \
       '' using 't':'hooke-newton attenuation' with lines linewidth 1.2 dashtype 2 linecolor rgb hn title 'hooke-newton', \
       '' using 't':'hunt-crossley attenuation' with lines linewidth 1.6 linecolor rgb hc title 'hunt-crossley'
}
if (figure == 10) {
  set ylabel 'energy dissipated by contact, J'
  set yrange [0:]
  plot traces using 't':'hertz dissipated' with lines dashtype 3 linewidth 1.6 linecolor rgb hz title 'hertz', \
       '' using 't':'hertz dissipated reference' with lines linewidth 0.9 linecolor rgb hz title 'hertz, reference', \
       '' using 't':'hooke-newton dissipated' with lines dashtype 2 linewidth 1.6 linecolor rgb hn title 'hooke-newton', \
       '' using 't':'hooke-newton dissipated reference' with lines linewidth 0.9 linecolor rgb hn title 'hooke-newton, reference', \
       '' using 't':'hunt-crossley dissipated' with lines linewidth 1.6 linecolor rgb hc title 'hunt-crossley', \
       '' using 't':'hunt-crossley dissipated reference' with lines linewidth 0.9 linecolor rgb hc title 'hunt-crossley, reference'
}
