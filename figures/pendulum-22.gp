load "figures/style.gp"
set logscale xy
set xrange [1:1000]
set yrange [1e-12:3]
set format y "10^{%T}"
set ytics 1e3
set xlabel "terms"
set ylabel "missing of {/:Italic l} 2"
set label "terms alone" at 100, 0.25 left textcolor linetype 2
set label "with a mean of the bounds" at 35, 3e-5 left textcolor linetype 3
set label "Levin’s transformation" at 13.5, 1e-10 left textcolor linetype 4
f = tsv("pendulum-22.errors")
plot f using "terms":"plain" with lines linetype 2, "" using "terms":"mean" with lines linetype 3, \
     "" using "terms":"levin" with linespoints linetype 4
