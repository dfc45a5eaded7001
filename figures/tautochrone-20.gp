load "figures/style.gp"
set logscale xy
set xrange [1e-4:0.6]
set yrange [1e-10:0.3]
set format xy "10^{%T}"
set ytics 1e-10, 100
set xlabel "height of the rise, {/:Italic c} / {/:Italic a}"
set ylabel "{/:Italic T} / {/:Italic T}_0 − 1"
file = tsv("tautochrone-20.excesses")
of(n) = column("cheeks") == n ? column("excess") : NaN
plot file using "c":(of(0)) with lines linetype 6, \
     file using "c":(of(1)) with lines linetype 3, \
     file using "c":(of(2)) with lines linetype 5, \
     file using "c":(of(3)) with lines linetype 2, \
     file index 0 every ::35::35 using "c":"excess":("circle") with labels left rotate by 13 offset 0.4, -1.0 textcolor linetype 6, \
     file index 1 every ::35::35 using "c":"excess":("Huygens’s cycloid") with labels left rotate by 13 offset 0.4, -1.0 textcolor linetype 3, \
     file index 2 every ::35::35 using "c":"excess":("Euler, with {/:Italic P}") with labels left rotate by 13 offset 0.4, -1.0 textcolor linetype 5, \
     file index 3 every ::35::35 using "c":"excess":("with {/:Italic P} and {/:Italic Q}") with labels left rotate by 13 offset 0.4, -1.0 textcolor linetype 2
