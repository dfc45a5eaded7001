load "figures/style.gp"
file = tsv("tautochrone-11.lengths")
set xrange [0:1]
set yrange [0:0.46]
set rmargin 3
set xtics ("0" 0, "{/:Italic a}/4" 0.25, "{/:Italic a}/2" 0.5, "3{/:Italic a}/4" 0.75, "{/:Italic a}" 1)
set ytics 0.1 format "%.1f"
set xlabel "length of the strip"
set ylabel "seconds a day late"
stats file using (column("light")) every ::39 name "A" nooutput
stats file using (column("middle")) every ::39 name "B" nooutput
stats file using (column("heavy")) every ::39 name "C" nooutput
stats file using (column("k05")) every ::39 name "D" nooutput
set label "1/1000" at 0.98, A_max + 0.018 right textcolor linetype 1
set label "3/1000" at 0.98, B_max + 0.018 right textcolor linetype 3
set label "μ = 1/100" at 0.98, C_max + 0.022 right textcolor linetype 2
set label "{/:Italic k} = {/:Italic a}/20" at 0.02, D_max + 0.018 left textcolor linetype 6
plot file using "l":"light" with lines linetype 1, "" using "l":"middle" with lines linetype 3, \
     "" using "l":"heavy" with lines linetype 2, "" using "l":"k05" with lines linetype 6
