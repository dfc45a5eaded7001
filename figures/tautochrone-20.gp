load "figures/style.gp"
set logscale xy
set xrange [1e-4:0.6]
set yrange [1e-10:0.3]
set format xy "10^{%T}"
set ytics 1e-10, 100
set xlabel "height of the rise, {/:Italic c} / {/:Italic a}"
set ylabel "{/:Italic T} / {/:Italic T}_0 − 1"
set label "circle" at 2e-3, 1e-3 right textcolor linetype 6
set label "Huygens’s cycloid" at 5e-3, 1.6e-5 left textcolor linetype 3
set label "Euler, with {/:Italic P}" at 5e-3, 4e-7 left textcolor linetype 5
set label "with {/:Italic P} and {/:Italic Q}" at 8e-3, 2.2e-8 left textcolor linetype 2
file = tsv("tautochrone-20.excesses")
of(n) = column("cheeks") == n ? column("excess") : NaN
plot file using "c":(of(0)) with lines linetype 6, \
     file using "c":(of(1)) with lines linetype 3, \
     file using "c":(of(2)) with lines linetype 5, \
     file using "c":(of(3)) with lines linetype 2
