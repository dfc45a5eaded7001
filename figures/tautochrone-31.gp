load "figures/style.gp"
set logscale y
set xrange [0:41]
set yrange [1e-17:1e2]
set ytics 1e-16, 1e4
set format y "10^{%T}"
set xlabel "places of Gauss’s rule"
set ylabel "relative error of the arc"
set label "30°" at 3.6, 1e-11 right textcolor linetype 1
set label "60°" at 8, 1e-11 left textcolor linetype 1
set label "75°" at 16.6, 1e-9 left textcolor linetype 1
set label "80°" at 24, 1e-7 left textcolor linetype 1
plot tsv("tautochrone-31.errors") using "nodes":"e30" with lines linetype 1, \
     "" using "nodes":"e60" with lines linetype 1, \
     "" using "nodes":"e75" with lines linetype 1, \
     "" using "nodes":"e80" with lines linetype 1
