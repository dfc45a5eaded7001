tall = 1
load "figures/style.gp"
set size ratio -1
unset border; unset tics; unset grid
lines = tsv("tautochrone-08.lines")
letters = tsv("tautochrone-08.letters")
stats lines using "q" name "B" nooutput
stats lines using "p" name "L" nooutput
array X[9]; array Y[9]
do for [i = 1:9] {
  stats letters every ::(i - 1)::(i - 1) using "aside" nooutput
  X[i] = STATS_min
  stats letters every ::(i - 1)::(i - 1) using "down" nooutput
  Y[i] = -STATS_min
}
set label "{/:Italic B}" at B_max + 0.03, -L_max textcolor linetype 2
least(x, y) = x < y ? x : y
set xrange [-0.12:-least(-1.05, -0.07 - X[9])]
set yrange [least(-1.14, least(Y[8], Y[9]) - 0.06):0.08]
# A M P G Q S C D H
name(i) = word("A M P G Q S C D H", i)
dx(i) = real(word("0.9 1.1 1.1 -0.2 1.1 1.1 -1.3 1.2 1.3", i))
dy(i) = real(word("0.6 0.5 0.5 1.5 0.6 0.6 0.2 0 -0.1", i))
do for [i = 1:9] {
  set label sprintf("{/:Italic %s}", name(i)) at X[i], Y[i] center offset dx(i), dy(i) textcolor linetype 7
}
set arrow from X[1], Y[1] to X[8], Y[8] nohead linetype 6
set arrow from X[3], Y[3] to X[2], Y[2] nohead linetype 6 dashtype 2
set arrow from X[5], Y[5] to X[4], Y[4] nohead linetype 6 dashtype 2
set arrow from X[2], Y[2] to X[6], Y[6] nohead linetype 6 dashtype 2
set arrow from X[2], Y[2] to X[9], Y[9] nohead linetype 1
set object circle at X[4], Y[4] size 0.045 fillstyle empty border linetype 7 front
plot lines using "q":(-column("p")) with lines linetype 2, \
     lines using "G_y":(-column("G_x")) with lines linetype 7 dashtype 3, \
     letters using "aside":(-column("down")) with points linetype 7
