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
plot file using "nodes":"raw" with lines linetype 2, \
     file using "nodes":"subtracted" with lines linetype 5, \
     file using "nodes":"alpha" with lines linetype 1, \
     file every ::38::38 using "nodes":"raw":("in φ") with labels left offset 0, 0.9 textcolor linetype 2, \
     file every ::44::44 using "nodes":(30 * column("subtracted")):("in α, heights subtracted") with labels center offset 0, 1.0 textcolor linetype 5, \
     file every ::4::4 using "nodes":"alpha":("in α") with labels left offset 1, 0.3 textcolor linetype 1
