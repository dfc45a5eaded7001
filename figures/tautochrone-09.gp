short = 1
load "figures/style.gp"
set size ratio -1
unset border; unset tics; unset grid
file = tsv("tautochrone-09.drawn")
array D[5]
do for [i = 1:5] {
  stats file using "D" every ::(i - 1)::(i - 1) nooutput
  D[i] = STATS_min
}
set xrange [-0.55:3.75]
set yrange [-1.5:0.2]
s = 0.84   # the bodies stand closer than their lengths
# ball, disc, disc from the edge, ring, rod
set object 1 circle at 0, -1 size first 0.3 fillstyle solid 0.18 border linetype 6 fillcolor rgb grey
set object 2 circle at s, -1 size first 0.3 fillstyle empty border linetype 7
set object 3 rectangle from 2 * s - 0.015, -1.3 to 2 * s + 0.015, -0.7 fillstyle empty border linetype 7
set object 4 circle at 3 * s, -1 size first 0.3 fillstyle empty border linetype 7
set object 5 circle at 3 * s, -1 size first 0.28 fillstyle empty border linetype 7
set object 6 rectangle from 4 * s - 0.3, -1.012 to 4 * s + 0.3, -0.988 fillstyle empty border linetype 7
do for [i = 0:4] {
  set arrow from i * s, 0 to i * s, -1 nohead linetype 6
  set label at i * s, 0 point linetype 7 pointtype 7
  set label "{/:Italic A}" at i * s, 0.12 center textcolor linetype 7
  set label "{/:Italic C}" at i * s - 0.06, -0.94 right textcolor linetype 7
  set label "{/:Italic D}" at i * s + 0.06, -D[i + 1] - 0.035 left textcolor linetype 2
}
do for [i = 0:3] { set arrow from -0.45, -1 - i * 0.1 to -0.40, -1 - i * 0.1 nohead linetype 6 }
set arrow from -0.425, -1 to -0.425, -1.3 nohead linetype 6
set label "ball" at 0, -1.42 center textcolor linetype 7
set label "disc" at s, -1.42 center textcolor linetype 7
set label "disc, across" at 2 * s, -1.42 center textcolor linetype 7
set label "ring" at 3 * s, -1.42 center textcolor linetype 7
set label "level rod" at 4 * s, -1.42 center textcolor linetype 7
plot file using (s * column("aside")):(-1) with points linetype 7, \
     file using (s * column("aside")):(-column("D")) with points linetype 2 pointtype 7
