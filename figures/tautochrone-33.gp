load "figures/style.gp"
set xrange [0:75]
set yrange [0:3]
set xtics 15 format "%g°"
set xlabel "angle φ"
set ylabel "{/:Italic ds} / {/:Italic d}φ, over {/:Italic a}"
set label "cycloid" at 66, 0.92 left textcolor linetype 6
set label "with one" at 66, 1.75 left textcolor linetype 5
set label "Euler’s cheek" at 50, 2.4 right textcolor linetype 2
set label "exact" at 66, 0.5 left textcolor linetype 1
plot tsv("tautochrone-33.bends") using "phi":"cycloid" with lines linetype 6, \
     "" using "phi":"kk" with lines linetype 5, \
     "" using "phi":"k4" with lines linetype 2, \
     tsv("tautochrone-33.exact") using "phi":"ds" with lines linetype 1
