load "figures/style.gp"
set xrange [0:1]
set yrange [0:1.05]
set xtics 0.2 format "%.1f"
set ytics 0.2 format "%.1f"
set lmargin 10
set xlabel "height of {/:Italic G}, {/:Italic x} / {/:Italic c}"
set ylabel "{/:Italic v} / {/:Italic c}"
file = tsv("tautochrone-18.speeds")
stats file using (column("k6")) every ::34::34 name "D" nooutput
stats file using (column("x")) every ::34::34 name "Y" nooutput
set label "{/:Italic k} = 0" at 0.42, 0.62 left textcolor linetype 7
set label "3{/:Italic a}/10" at 0.085, 0.745 left textcolor linetype 3
set label "6{/:Italic a}/10" at Y_max - 0.01, D_max - 0.04 right textcolor linetype 2
set label "fixed axis" at 0.205, 0.612 left textcolor linetype 6
set label "{/:Italic a}/10" at 0.10, 0.97 left textcolor linetype 1
plot file using "x":"k0" with lines linetype 7, \
     file using "x":"axis" with lines linetype 6, \
     file using "x":"k1" with lines linetype 1, \
     file using "x":"k3" with lines linetype 3, \
     file using "x":"k6" with lines linetype 2
