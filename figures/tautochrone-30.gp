load "figures/style.gp"
stats tsv("tautochrone-30.radius") using "phi" name "E" nooutput
set xrange [0 : 1.1 * E_max]
set xtics 15 format "%g°"
set yrange [0:1.05]
set xlabel "angle φ with the vertical"
set ylabel "{/:Italic r} / {/:Italic a}"
plot tsv("tautochrone-30.radius") using "phi":"n0" with lines linetype 6, \
     "" using "phi":"n1" with lines linetype 5, \
     "" using "phi":"n2" with lines linetype 2, \
     "" using "phi":"exact" with lines linetype 1, \
     "" using "phi":"exact" every ::140::140 with points linetype 1, \
     "" every ::116::116 using "phi":"n0":("cycloid") with labels left offset 0.6, 0.8 textcolor linetype 6, \
     "" every ::137::137 using "phi":"n1":("with {/:Italic P}") with labels left offset 0.8, 0.2 textcolor linetype 5, \
     "" every ::126::126 using "phi":"n2":("Euler") with labels right offset -0.8, 0 textcolor linetype 2, \
     "" every ::103::103 using "phi":"exact":("exact, the highest") with labels right offset -0.8, -0.4 textcolor linetype 1
