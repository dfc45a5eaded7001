tall = 1
load "figures/style.gp"
set xrange [0:60]
set yrange [0:1.05]
set xtics 15 format "%g°"
set xlabel "angle φ"
set ylabel "{/:Italic r} / {/:Italic a}"
file = tsv("tautochrone-25.plane")
of(n) = column("kind") == n ? column("r") : NaN
set label "highest" at 52.5, 0.52 left textcolor linetype 1
set label "widest" at 50, 0.25 left textcolor linetype 1
set label "Euler" at 44.2, 0.2 right textcolor linetype 2
set label "{/:Italic dr} = 0" at 40, 0.77 left textcolor linetype 6
plot file using "phi":(of(3)) with lines linetype 6 dashtype (5, 4), \
     file using "phi":(of(1)) with lines linetype 3, \
     file using "phi":(of(2)) with lines linetype 2, \
     file using "phi":(of(0)) with lines linetype 1
