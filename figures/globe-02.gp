load "figures/style.gp"
set size ratio -1
unset border; unset tics; unset grid
file = tsv("globe-02.points")
array X[7]; array Y[7]
stats file using (X[int($0) + 1] = column("x"), Y[int($0) + 1] = column("y")) nooutput
left = X[1] < X[2] - 1 ? X[1] : X[2] - 1
right = X[1] > X[2] + 1 ? X[1] : X[2] + 1
set xrange [left - 0.25:right + 0.45]
set yrange [-0.28:2.08]
set arrow from left - 0.2, 0 to right + 0.4, 0 nohead linetype 7
set arrow from X[3], Y[3] to X[2], Y[2] nohead linetype 6
set arrow from X[3], Y[3] to X[4], Y[4] nohead linetype 6
set arrow from X[5], Y[5] to X[6], Y[6] nohead linetype 6
set arrow from X[5], Y[5] to X[7], Y[7] nohead linetype 6
set arrow from X[3], Y[3] to X[5], Y[5] nohead linetype 1 linewidth 3
set label "{/:Italic I}" at X[1], -0.13 center textcolor linetype 7
set label "{/:Italic O}" at right + 0.38, -0.13 center textcolor linetype 7
set label "{/:Italic S}" at X[2] + 0.02, -0.13 left textcolor linetype 7
set label "{/:Italic P}" at X[6] - 0.02, -0.13 right textcolor linetype 7
set label "{/:Italic C}" at X[3], Y[3] + 0.1 center textcolor linetype 7
set label "{/:Italic A}" at X[3] + 1.12 * (X[4] - X[3]), Y[3] + 1.12 * (Y[4] - Y[3]) center textcolor linetype 7
set label "{/:Italic G}" at X[5] + (X[5] > X[3] ? 0.08 : -0.08), Y[5] + 0.07 center textcolor linetype 1
set label "{/:Italic Q}" at X[7] + (X[5] > X[3] ? -0.09 : 0.09), Y[7] center textcolor linetype 7
plot tsv("globe-02.circle") using "x":"y" with lines linetype 7, \
     tsv("globe-02.arc") using "x":"y" with lines linetype 3, \
     "" using (X[3] + 0.68 * (column("x") - X[3])):(Y[3] + 0.68 * (column("y") - Y[3])):("Φ") every 1::20::20 with labels textcolor linetype 3, \
     file using "x":"y" with points linetype 7 pointsize 0.7
