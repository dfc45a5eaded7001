load "figures/style.gp"
set logscale xy
set xrange [1:1000]
set yrange [1e-12:3]
set format y "10^{%T}"
set ytics 1e3
set xlabel "terms"
set ylabel "missing of {/:Italic l} 2"
set label "terms alone" at 100, 0.25 left textcolor linetype 2
set label "Levin’s transformation" at 18, 4e-11 left textcolor linetype 4
f = tsv("pendulum-22.errors")
plot f using "terms":"plain" with lines linetype 2, "" using "terms":"levin" with linespoints linetype 4
