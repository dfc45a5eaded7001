load "figures/style.gp"
set xrange [0:80]
set yrange [0:1.12]
set xtics 20 format "%g°"
set ytics 0.2 format "%.1f"
set lmargin 11
set xlabel "angle φ"
set ylabel "{/:Italic P} : {/:Italic M} sin φ"
file = tsv("tautochrone-16.parts")
stats file using (column("axis")) every ::1::1 name "A" nooutput
stats file using (column("end")) every ::66::66 name "E" nooutput
stats file using (column("cycloid")) every ::20::20 name "C" nooutput
set label "fixed axis" at 2, A_max - 0.045 left textcolor linetype 6
set label "swing to 80° between cycloids" at 20, C_max + 0.05 left textcolor linetype 1
set label "where swings end" at 63, E_max - 0.02 right textcolor linetype 3
plot file using "phi":"axis" with lines linetype 6, \
     file using "phi":"end" with lines linetype 3 dashtype (6, 4), \
     file using "phi":"cycloid" with lines linetype 1
