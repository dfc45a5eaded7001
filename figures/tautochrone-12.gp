load "figures/style.gp"
file = tsv("tautochrone-12.errors")
stats file using (log10(column("width"))) every ::15::15 name "A" nooutput
stats file using (log10(column("time"))) every ::15::15 name "B" nooutput
stats file using (log10(column("double"))) every ::15::15 name "C" nooutput
stats file using (log10(column("k"))) every ::15::15 name "X" nooutput
set logscale xy
set xrange [0.001:1]
set yrange [1e-16:100]
set xtics ("0.001" 0.001, "0.01" 0.01, "0.1" 0.1, "1" 1)
set ytics ("10^{−15}" 1e-15, "10^{−10}" 1e-10, "10^{−5}" 1e-5, "1" 1)
set xlabel "{/:Italic k}/{/:Italic a}"
set ylabel "δ{/:Italic k}/{/:Italic k}" offset 0.5, 0
set arrow from 0.001, 1 to 1, 1 nohead linetype 6
set label "swings of 1°" at 10**X_min * 1.25, 10**A_min * 3 left textcolor linetype 2
set label "ε = 10^{−6}" at 10**X_min / 1.35, 10**B_min / 6 right textcolor linetype 3
set label "{/:Italic AD} as a double" at 10**X_min * 1.25, 10**C_min * 3 left textcolor linetype 1
plot file using "k":"width" with lines linetype 2, "" using "k":"time" with lines linetype 3, \
     "" using "k":"double" with lines linetype 1
