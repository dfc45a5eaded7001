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
plot tsv("tautochrone-26.defects") using "phi":"circle" with lines linetype 6, \
     "" using "phi":"cycloid" with lines linetype 3, \
     "" using "phi":"kk" with lines linetype 5, \
     "" using "phi":"k4" with lines linetype 2, \
     "" every ::20::20 using "phi":"circle":("circle") with labels left offset 0, 0.9 textcolor linetype 6, \
     "" every ::40::40 using "phi":"cycloid":("Huygens’s cycloid") with labels center offset 0, 1.0 textcolor linetype 3, \
     "" every ::30::30 using "phi":"kk":("Euler, with {/:Italic P}") with labels right offset 1, 0.8 textcolor linetype 5, \
     "" every ::24::24 using "phi":"k4":("with {/:Italic P} and {/:Italic Q}") with labels left offset 1, -0.7 textcolor linetype 2
