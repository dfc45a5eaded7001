load "figures/style.gp"
set xrange [0:78]
set xtics 15 format "%g°"
set yrange [0:1.05]
set xlabel "angle φ with the vertical"
set ylabel "{/:Italic r} / {/:Italic a}"
set label "cycloid" at 59, 0.58 left textcolor linetype 6
set label "with {/:Italic P}" at 70.4, 0.14 left textcolor linetype 5
set label "Euler" at 63.2, 0.12 right textcolor linetype 2
set label "exact, the highest" at 52, 0.45 right textcolor linetype 1
plot tsv("tautochrone-30.radius") using "phi":"n0" with lines linetype 6, \
     "" using "phi":"n1" with lines linetype 5, \
     "" using "phi":"n2" with lines linetype 2, \
     "" using "phi":"exact" with lines linetype 1, \
     "" using "phi":"exact" every ::140::140 with points linetype 1
