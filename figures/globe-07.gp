load "figures/style.gp"
file = tsv("globe-07.arms")
array P[181]; array F[181]
stats file using (P[int($0) + 1] = column("pressure"), F[int($0) + 1] = column("friction")) nooutput
set xrange [0:360]
set xtics 0, 90, 360
set xlabel "angle Φ (degrees)"
set lmargin 9
set ylabel "arm about {/:Italic G}, in radii" offset -0.3, 0
set xzeroaxis linetype 6
set label "of the friction" at 180, F[91] offset 0, 0.8 center textcolor linetype 1
set label "of the pressure" at 228, P[115] right offset -2.2, 0 textcolor linetype 2
set yrange [(P[136] < F[1] ? P[136] : F[1]) - 0.12:*]
higher(p, f) = p > f ? p : f
plot file using "Phi_deg":"friction":(higher(column("pressure"), column("friction"))) with filledcurves linetype 2, \
     file using "Phi_deg":"pressure" with lines linetype 2, \
     file using "Phi_deg":"friction" with lines linetype 1
