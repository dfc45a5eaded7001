load "figures/style.gp"
set logscale xy
set xrange [1e-7:1e-1]
set yrange [1e-10:1]
set format xy "10^{%T}"
set ytics 1e-10, 100
set xlabel "step, as a part of {/:Italic x} or {/:Italic z}"
set ylabel "relative error of {/:Italic r}"
set label "by {/:Italic ddx}" at 1e-2, 1e-4 right textcolor linetype 2
set label "by {/:Italic ddy}" at 1.5e-2, 8e-6 left textcolor linetype 1
set label "by {/:Italic ddz}" at 4e-3, 5e-7 left textcolor linetype 3
plot tsv("tautochrone-24.errors") using "step":"by_y" with lines linetype 1, \
     "" using "step":"by_z" with lines linetype 3, \
     "" using "step":"by_x" with lines linetype 2
