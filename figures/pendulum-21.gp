load "figures/style.gp"
set logscale xy
set xrange [1:1000]
set yrange [1e-16:3]
set format y "10^{%T}"
set ytics 1e3
set xlabel "rows or columns added"
set ylabel "missing"
set label "rows, α = 2½° and 30°" at 60, 0.4 left textcolor linetype 2
set label "columns, 2½°" at 4.1, 1e-12 right textcolor linetype 1
set label "columns, 30°" at 14, 1e-7 left textcolor linetype 1
r = tsv("pendulum-21.rows"); k = tsv("pendulum-21.columns")
plot r using "count":"small" with lines linetype 2, "" using "count":"large" with lines linetype 2, \
     k using "count":"small" with linespoints linetype 1, "" using "count":"large" with linespoints linetype 1
