load "figures/style.gp"
set size ratio -1
set xrange [0.36:0.68]
set yrange [0.07:0.27]
set xtics 0.1 format "%.1f"
set ytics 0.05 format "%.2f"
set lmargin 10
set xlabel "{/:Italic y} / {/:Italic a}"
set ylabel "{/:Italic x} / {/:Italic a}" offset 0, 0
file = tsv("tautochrone-32.curves")
of(n) = column("kind") == n ? column("x") : NaN
set label "circle" at 0.645, 0.222 left textcolor linetype 6
set label "cycloid" at 0.636, 0.257 right textcolor linetype 3
set label "exact" at 0.598, 0.245 right textcolor linetype 1
set label "Euler" at 0.5905, 0.2245 left textcolor linetype 2
plot file using "y":(of(0)) with lines linetype 6, \
     file using "y":(of(1)) with lines linetype 3, \
     file using "y":(of(3)) with lines linetype 1, \
     file using "y":(of(2)) with lines linetype 2, \
     file index 2 every ::60::60 using "y":"x" with points linetype 2, \
     file index 3 every ::59::59 using "y":"x" with points linetype 1
