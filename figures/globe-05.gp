load "figures/style.gp"
file = tsv("globe-05.radius")
stats file using (column("rule")) name "R" nooutput
stats file using (column("right")) name "T" nooutput
stats file using (P = column("G"), 0) nooutput
array E[121]
stats file using (E[int($0) + 1] = column("rule")) nooutput
low = R_min < T_min ? R_min : T_min
high = R_max > T_max ? R_max : T_max
room = high > low ? high - low : 1
set xrange [-1:1]
set yrange [low - 0.1 * room:high + 0.15 * room]
set rmargin 8
set xtics ("" -1, "−½" -0.5, "{/:Italic C}" 0, "½" 0.5, "{/:Italic A}" 1)
set xlabel "place of the point on the diameter, in radii"
set ylabel "angular acceleration (1/s²)"
set label "true" at graph 1.01, first T_max left textcolor linetype 1
set label "by the rule" at 0.55, E[94] offset 0, 1 left textcolor linetype 2
set label "{/:Italic G}" at P, T_max offset 0.8, 0.8 left textcolor linetype 7
plot file using "from_C":"right" with lines linetype 1, \
     file using "from_C":"rule" with lines linetype 2, \
     file every ::0::0 using "G":"right" with points linetype 7 pointsize 1
