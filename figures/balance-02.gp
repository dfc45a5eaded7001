load "figures/style.gp"
set size ratio -1
unset border; unset tics; unset grid
file = tsv("balance-02.plate")
array X[13]; array Y[13]
stats file using (X[int($0) + 1] = column("x"), Y[int($0) + 1] = column("y")) nooutput
# A B C G P Q p q α ε β r s
right = X[2]; left = X[1]; low = Y[11]; high = 0
do for [i = 1:13] {
  right = X[i] > right ? X[i] : right; left = X[i] < left ? X[i] : left
  low = Y[i] < low ? Y[i] : low; high = Y[i] > high ? Y[i] : high
}
s = 0.5 * ((right - left) > (high - low) ? right - left : high - low)
set xrange [left - 0.22 * s:right + 0.22 * s]
set yrange [low - 0.16 * s:high + 0.18 * s]
set arrow from left - 0.16 * s, 0 to right + 0.16 * s, 0 nohead linetype 6
set arrow from 0, 0 to 0, -0.6 * s nohead linetype 6
set arrow from X[1], Y[1] to X[1], low nohead linetype 6
set arrow from X[2], (Y[2] > 0 ? Y[2] : 0) to X[11], Y[11] nohead linetype 6
set arrow from X[5], (Y[12] > 0 ? Y[12] : 0) to X[5], Y[5] nohead linetype 6
set arrow from X[6], (Y[13] > 0 ? Y[13] : 0) to X[6], Y[6] nohead linetype 6
set arrow from X[1], Y[1] to X[12], Y[12] nohead linetype 6
set arrow from X[2], Y[2] to X[13], Y[13] nohead linetype 6
set arrow from 0, 0 to X[4], Y[4] nohead linetype 7 linewidth 1.4
d = 0.07 * s
set label "{/:Italic A}" at X[1], Y[1] + d center
set label "{/:Italic B}" at X[2] + 0.8 * d, Y[2] + 0.3 * d center
set label "{/:Italic C}" at 0, d center
set label "{/:Italic G}" at X[4] - 0.8 * d, Y[4] center
set label "{/:Italic c}" at 0.6 * d, -0.58 * s center
set label "{/:Italic P}" at X[5], Y[5] - d center
set label "{/:Italic Q}" at X[6], Y[6] - d center
set label "{/:Italic p}" at X[7] - 0.6 * d, -0.7 * d center
set label "{/:Italic q}" at X[8] - 0.6 * d, 0.7 * d center
set label "α" at X[9] + 0.6 * d, -0.7 * d center
set label "ε" at X[10] + 0.6 * d, 0.7 * d center
set label "β" at X[11] + 0.7 * d, Y[11] center
set label "{/:Italic r}" at X[12] - 0.7 * d, Y[12] center
set label "{/:Italic s}" at X[13] - 0.7 * d, Y[13] center
set label "η" at X[1] - 0.10 * s * (X[5] < X[1] ? 1 : -1), Y[1] - 0.40 * s center textcolor linetype 1
set label "ϑ" at X[2] - 0.12 * s * (X[6] < X[2] ? 1 : -1), Y[2] - 0.40 * s center textcolor linetype 1
set label "ω" at 0.5 * X[1], 0.25 * Y[1] center textcolor linetype 1
plot file every ::0::1 using "x":"y" with lines linetype 7 linewidth 2.2, \
     "" every 4::0::4 using "x":"y" with lines linetype 7 linewidth 1.4, \
     "" every 4::1::5 using "x":"y" with lines linetype 7 linewidth 1.4, \
     "" every ::2::5 using "x":"y" with points linetype 7 pointsize 1
