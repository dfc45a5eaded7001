load "figures/style.gp"
file = tsv("tautochrone-04.balls")
stats file using (log10(column("air"))) every ::15::15 name "A" nooutput
stats file using (log10(column("R"))) every ::15::15 name "X" nooutput
stats file using (log10(column("body"))) every ::21::21 name "B" nooutput
stats file using (log10(column("R"))) every ::21::21 name "Y" nooutput
set logscale xy
set xrange [0.001:0.2]
set yrange [5e-7:10]
set xtics ("0.001" 0.001, "0.01" 0.01, "0.1" 0.1)
set ytics ("10^{−6}" 1e-6, "10^{−4}" 1e-4, "0.01" 0.01, "1" 1)
set xlabel "radius of the ball, {/:Italic R}/{/:Italic a}"
set ylabel "seconds a day late" offset 0.5, 0
set label "resistance of the air" at 10**X_min * 1.3, 10**(A_min) left textcolor linetype 2
set label "extension of the ball" at 10**Y_min / 1.25, 2.2 * 10**(B_min) right textcolor linetype 1
plot file using "R":"air" with lines linetype 2, "" using "R":"body" with lines linetype 1
