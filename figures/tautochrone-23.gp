load "figures/style.gp"
set xrange [0:42]
set yrange [0.998:1.02]
set ytics 1, 0.005
set format y "%.3f"
set xtics 10 format "%g°"
set xlabel "amplitude φ_0"
set ylabel "{/:Italic T} / {/:Italic T}_0" offset 0, 0
set label "circle" at 23, 1.0128 right textcolor linetype 6
set label "Huygens’s cycloid" at 30.5, 1.0064 left textcolor linetype 3
set label "Euler, with {/:Italic P}" at 30.5, 1.0029 left textcolor linetype 5
set label "with {/:Italic P} and {/:Italic Q}" at 30.5, 1.0014 left textcolor linetype 2
plot tsv("tautochrone-23.times") using "phi0":"circle" with lines linetype 6, \
     "" using "phi0":"cycloid" with lines linetype 3, \
     "" using "phi0":"kk" with lines linetype 5, \
     "" using "phi0":"k4" with lines linetype 2
