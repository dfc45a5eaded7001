load "figures/style.gp"
set size ratio -1
unset border; unset tics; unset grid
base = tsv("globe-32.base")
file = tsv("globe-32.letters")
array X[5]; array Y[5]; array U[5]; array V[5]
stats file using (X[int($0) + 1] = column("x"), Y[int($0) + 1] = column("y")) nooutput
stats file using (U[int($0) + 1] = column("x_rolled"), V[int($0) + 1] = column("y_rolled")) nooutput
set xrange [-1.35:2.35]
set yrange [-0.2:1.45]
set arrow from -1.25, 0 to 2.25, 0 nohead linetype 7
set arrow from X[1], Y[1] to X[3], Y[3] nohead linetype 7
set arrow from U[1], V[1] to U[3], V[3] nohead linetype 6
set arrow from U[1], V[1] to U[1], 0 nohead linetype 6 dashtype 2
set label "{/:Italic I}" at -1.25, -0.1 center textcolor linetype 7
set label "{/:Italic O}" at 2.22, -0.1 center textcolor linetype 7
set label "{/:Italic C}" at X[1] - 0.09, Y[1] + 0.04 center textcolor linetype 7
set label "{/:Italic G}" at X[2] - 0.09, Y[2] + 0.02 center textcolor linetype 1
set label "{/:Italic R}" at X[3], Y[3] - 0.1 center textcolor linetype 7
set label "{/:Italic P}" at X[4] - 0.09, Y[4] center textcolor linetype 7
set label "{/:Italic Q}" at X[5] + 0.09, Y[5] center textcolor linetype 7
set label "{/:Italic S}" at U[1], -0.1 center textcolor linetype 6
plot base using "x_rolled":"y_rolled" with lines linetype 6, \
     base using "x":"y" with lines linetype 7, \
     file using "x_rolled":"y_rolled" every ::0::1 with points linetype 6 pointtype 7, \
     file using "x":"y" every ::0::2 with points linetype 7 pointsize 0.7, \
     file using "x":"y" every ::1::1 with points linetype 1 pointsize 0.9
