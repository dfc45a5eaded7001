tall = 1
load "figures/style.gp"
file = tsv("globe-26.round")
stats file using "Phi_deg":"S" index 0 nooutput
most = 5 * abs(STATS_mean_y)
set xrange [0:180]
set xtics 30
set rmargin 3
set lmargin 12
set multiplot layout 2, 1
set ylabel "{/:Italic S} over {/:Italic a}" offset -1, 0
set yrange [-most:most]
set format x ""
plot 0 with lines linetype 6, for [i = 0:2] file using "Phi_deg":"S" index i with lines linetype (i == 0 ? 1 : i + 2)
set ylabel "λ"
set format x "%g"
set xlabel "Φ (degrees)"
set yrange [*:*]
plot 0 with lines linetype 6, for [i = 0:2] file using "Phi_deg":"lambda" index i with lines linetype (i == 0 ? 1 : i + 2), \
     for [i = 0:2] file using "Phi_deg":"lambda":(sprintf("{/:Italic h} = %.4g", column("h"))) index i every ::(120 - 45 * (i == 1) - 30 * (i == 2))::(120 - 45 * (i == 1) - 30 * (i == 2)) with labels offset 0, (i == 1 ? -0.9 : 0.9) textcolor linetype (i == 0 ? 1 : i + 2)
unset multiplot
