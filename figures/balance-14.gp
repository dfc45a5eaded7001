load "figures/style.gp"
file = tsv("balance-14.length")
set datafile columnheaders
stats file using "c":"f" nooutput name "S"
stats file using "c":"without_pans" nooutput name "W"
set logscale xy
set xrange [S_min_x:S_max_x]
set yrange [W_min_y / 2:S_max_y]
set xlabel "{/:Italic c} (feet)"
set ylabel "{/:Italic f} (feet)" offset 0, 0
set lmargin 9
set format x "%g"
set format y "%g"
set label "with the pans" at S_min_x ** 0.75 * S_max_x ** 0.25, S_min_y ** 0.42 * S_max_y ** 0.58 left \
  textcolor linetype 1
set label "without" at S_min_x ** 0.85 * S_max_x ** 0.15, W_min_y ** 0.55 * W_max_y ** 0.45 right \
  textcolor linetype 3
set label "least" at S_pos_min_y, S_min_y * 1.35 center textcolor linetype 6
plot file using "c":"f" with lines linetype 1, "" using "c":"without_pans" with lines linetype 3
