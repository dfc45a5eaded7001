load "figures/style.gp"
set xrange [0:75]
set xtics 15 format "%g°"
set logscale y
set yrange [1e-10:10]
set format y "10^{%T}"
set xlabel "angle φ with the vertical"
set ylabel "error of {/:Italic r} / {/:Italic a}"

set label "cycloid" at 22, 1.2e-2 center textcolor linetype 6
set label "{/:Italic n} = 1" at 22, 5e-4 center textcolor linetype 5
set label "2, Euler" at 24.5, 2.2e-6 center textcolor linetype 2
set label "4" at 15, 4e-8 center textcolor linetype 3
set label "8" at 23.8, 3e-9 center textcolor linetype 4
error(name) = abs(column(name) - column("exact"))
plot tsv("tautochrone-30.radius") using "phi":(error("n0")) with lines linetype 6, \
     "" using "phi":(error("n1")) with lines linetype 5, \
     "" using "phi":(error("n2")) with lines linetype 2, \
     "" using "phi":(error("n4")) with lines linetype 3, \
     "" using "phi":(error("n8")) with lines linetype 4
