load "figures/style.gp"
set xrange [0:80]
set yrange [0:0.8]
set rmargin 8
set xtics 20 format "%g°"
set ytics format "%.1f"
set xlabel "angle φ"
set ylabel "share of the rotation"
file = tsv("tautochrone-13.shares")
stats file using (column("k1")) every ::80 name "A" nooutput
stats file using (column("k2")) every ::80 name "B" nooutput
stats file using (column("k3")) every ::80 name "C" nooutput
set label "{/:Italic a}/10" at 81, A_max left textcolor linetype 1
set label "2{/:Italic a}/10" at 81, B_max left textcolor linetype 3
set label "{/:Italic k} = 3{/:Italic a}/10" at 72, C_max right textcolor linetype 2
stats file using (column("axis")) every ::80 name "F" nooutput
set label "fixed axis" at 79, F_max - 0.035 right textcolor linetype 6
plot file using "phi":"k1" with lines linetype 1, "" using "phi":"k2" with lines linetype 3, \
     "" using "phi":"k3" with lines linetype 2, "" using "phi":"axis" with lines linetype 6
