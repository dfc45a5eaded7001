tall = 1
load "figures/style.gp"
set size ratio -1
unset border; unset tics; unset grid
file = tsv("balance-06.outline")
array X[7]; array Y[7]
stats file using (X[int($0) + 1] = column("x"), Y[int($0) + 1] = column("y")) nooutput
reach = abs(X[2]) + 0.02
do for [i = 1:7] { reach = abs(X[i]) > reach ? abs(X[i]) : reach; reach = abs(Y[i]) > reach ? abs(Y[i]) : reach }
s = reach
set xrange [-1.25 * s:1.25 * s]
low = Y[1] < Y[5] ? Y[1] : Y[5]
high = Y[4] > Y[2] ? Y[4] : Y[2]
set yrange [(low < 0 ? low : 0) - 0.12 * s:(high > 0 ? high : 0) + 0.15 * s]
set arrow from -1.2 * s, 0 to 1.2 * s, 0 nohead linetype 6
set arrow from X[4], Y[4] to X[7], Y[7] nohead linetype 6
set arrow from X[4], Y[4] to X[6], Y[6] nohead linetype 6
set arrow from X[5], Y[5] to X[6], Y[6] nohead linetype 6
set label "{/:Italic A}" at X[4], Y[4] + 0.06 * s center textcolor linetype 7
set label "{/:Italic B}" at X[2] + 0.05 * s, Y[2] center textcolor linetype 7
set label "{/:Italic C}" at 0, 0.06 * s center textcolor linetype 7
set label "{/:Italic P}" at X[5], Y[5] - 0.07 * s center textcolor linetype 7
set label "{/:Italic Q}" at X[1], Y[1] - 0.07 * s center textcolor linetype 7
set label "{/:Italic r}" at X[6] - 0.05 * s, Y[6] center textcolor linetype 7
set label "α" at X[7] + 0.05 * s, -0.05 * s center textcolor linetype 7
set label "{/:Italic p}" at X[5] - 0.05 * s, -0.05 * s center textcolor linetype 7
set label "{/:Italic q}" at X[1], 0.05 * s center textcolor linetype 7
set arrow from X[1], 0 to X[1], Y[1] nohead linetype 6
plot file every ::0::4 using "x":"y" with lines linetype 1, \
     file every 4::0::4 using "x":"y" with points linetype 7 pointsize 0.9
