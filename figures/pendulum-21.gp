load "figures/style.gp"
set logscale xy
set xrange [1:1000]
set yrange [1e-16:3]
set format y "10^{%T}"
set ytics 1e3
set xlabel "rows or columns added"
set ylabel "missing of {/:Italic t}√(2{/:Italic g}/{/:Italic b})"
set label "rows, α = 2½° and 30°" at 60, 0.4 left textcolor linetype 2
set label "2½°" at 4.1, 1e-12 right textcolor linetype 1
set label "columns, 30°" at 14, 1e-7 left textcolor linetype 1
f = tsv("pendulum-21.missing")
plot for [name in "rows_small rows_large"] f using "count":name with lines linetype 2, \
     for [name in "columns_small columns_large"] f using "count":name with linespoints linetype 1
