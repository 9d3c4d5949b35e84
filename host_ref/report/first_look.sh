#!/bin/sh
# The paper's scene in a sentence a law, and its picture: first_look.sh RUNS.csv PICTURE.svg. RUNS.csv is what
# target/paper_runs.cpp prints.
set -eu
runs=$1 picture=$2
echo "The paper's scene, 5 s at 40 rad/s in steps of 0.1 ms, in 32-bit fixed point:"
awk -F, '
  $1 < 4 && $2 == 50000 { peak[$1] = $4 / 1e6; energy[$1] = $5 / 1e9 }
  END {
    if (!(3 in peak)) { print "the runs have no end" > "/dev/stderr"; exit 1 }
    split("Hooke-Newton,Hertz,Hunt-Crossley", name, ",")
    printf "  Without the ball the main mass reaches %.1f mm.\n", peak[0]
    for (law = 1; law <= 3; ++law) {
      printf "  With a ball and %s contact it reaches %.1f mm, %.0f %% %s; the contacts dissipate %.2f J.\n", name[law],
        peak[law], 100 * (peak[law] < peak[0] ? 1 - peak[law] / peak[0] : peak[law] / peak[0] - 1),
        peak[law] < peak[0] ? "less" : "more", int(100 * energy[law] + 0.5) / 100
    }
  }' "$runs"
gnuplot -c /dev/stdin "$picture" "$runs" <<'END'
set terminal svg size 900,430 dynamic font 'sans-serif,15' noenhanced background rgb 'white'
set output ARG1
set encoding utf8
set datafile separator comma
set datafile missing NaN
set border 3 linecolor rgb 'black'
set tics nomirror
set grid linecolor rgb 'gray' linetype 1 linewidth 0.4
set xlabel 'time, s'
set ylabel 'displacement of the main mass, mm'
set key below center maxrows 1
of(run) = $1 == run ? $3 * 1e-6 : NaN
plot ARG2 using ($2 * 1e-4):(of(0)) skip 1 with lines linewidth 1 linecolor rgb '#808080' title 'without absorber', \
     '' using ($2 * 1e-4):(of(3)) skip 1 with lines linewidth 1.8 linecolor rgb '#0072B2' \
     title 'with absorber, Hunt-Crossley'
END
echo "Its picture: $picture"
