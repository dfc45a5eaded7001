load "figures/style.gp"
file = tsv("globe-06.turn")
array B[181]; array S[181]; array F[181]
stats file using (B[int($0) + 1] = column("back"), S[int($0) + 1] = column("smooth"), F[int($0) + 1] = column("on")) nooutput
set xrange [0:360]
set xtics 0, 90, 360
set xlabel "angle Φ (degrees)"
set ylabel "pressure over weight, Π/{/:Italic P}"
set label "scraping forwards" at 80, F[41] offset 1, 0.8 left textcolor linetype 1
set label "scraping back" at 280, B[141] offset -1, 0.8 right textcolor linetype 2
set label "smooth" at 70, S[36] offset 0.6, 0.5 left textcolor linetype 6
plot file using "Phi_deg":"smooth" with lines linetype 6, \
     file using "Phi_deg":"back" with lines linetype 2, \
     file using "Phi_deg":"on" with lines linetype 1
