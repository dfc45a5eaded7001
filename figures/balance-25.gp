load "figures/style.gp"
set xlabel "λ{/:Italic t} (degrees)"
set ylabel "hundredths"
set xrange [0:720]
set xtics 90
file = tsv("balance-25.modulation")
stats file using "phase" name "H" nooutput
set yrange [-1.25 * H_max:1.25 * H_max]
set label "phase" at 90, 1.1 * H_max center textcolor linetype 1
set label "width" at 330, 0.3 * H_max right textcolor linetype 3
plot file using "turn":"phase" with lines linetype 1, file using "turn":"width" with lines linetype 3
