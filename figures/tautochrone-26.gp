load "figures/style.gp"
set logscale y
set xrange [0:60]
set yrange [1e-8:10]
set format y "10^{%T}"
set ytics 1e-8, 100
set xtics 15 format "%g°"
set lmargin 10
set xlabel "angle φ"
set ylabel "defect of the proportion"
set label "circle" at 20, 0.1 left textcolor linetype 6
set label "Huygens’s cycloid" at 27, 8e-3 center textcolor linetype 3
set label "Euler, with {/:Italic P}" at 20, 2.5e-4 center textcolor linetype 5
set label "with {/:Italic P} and {/:Italic Q}" at 24, 1e-6 left textcolor linetype 2
plot tsv("tautochrone-26.defects") using "phi":"circle" with lines linetype 6, \
     "" using "phi":"cycloid" with lines linetype 3, \
     "" using "phi":"kk" with lines linetype 5, \
     "" using "phi":"k4" with lines linetype 2
