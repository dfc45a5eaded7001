load "figures/style.gp"
set xrange [0:72]
set yrange [-1.1:1.1]
set xtics 15 format "%g°"
set lmargin 9
set xlabel "angle φ"
set ylabel "pieces of the terms with {/:Italic kk}"
set label "sin^2φ" at 44, 0.6 right textcolor linetype 1
set label "cos^2φ − cos^4φ" at 71, 0.3 right textcolor linetype 3
set label "{/:Italic P} cos^3φ" at 40, -0.8 right textcolor linetype 2
plot tsv("tautochrone-29.pieces") using "phi":"of_dr" with lines linetype 1, \
     "" using "phi":"of_a" with lines linetype 3, \
     "" using "phi":"of_P" with lines linetype 2
