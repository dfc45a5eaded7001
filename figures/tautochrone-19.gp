load "figures/style.gp"
set logscale xy
set xrange [2:40000]
set yrange [1e-17:1]
set ytics 1e-16, 1e4
set format y "10^{%T}"
set format x "10^{%T}"
set lmargin 10
set xlabel "places"
set ylabel "relative error of {/:Italic T}"
file = tsv("tautochrone-19.errors")
set label "in φ" at 300, 0.12 left textcolor linetype 2
set label "in α, heights subtracted" at 60, 2e-12 left textcolor linetype 5
set label "in α" at 6.5, 1e-9 left textcolor linetype 1
plot file using "nodes":"raw" with lines linetype 2, \
     file using "nodes":"subtracted" with lines linetype 5, \
     file using "nodes":"alpha" with lines linetype 1
