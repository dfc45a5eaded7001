load "figures/style.gp"
set size ratio -1
unset border; unset tics; unset grid
file = tsv("globe-03.paths")
gap = 2.9
set xrange [-3.9:16.4]
set yrange [-0.4:2 * gap + 2.5]
do for [i = 0:2] {
  set arrow from -3.9, (2 - i) * gap to 15.6, (2 - i) * gap nohead linetype 7 linewidth 0.7
}
set label "scrapes on" at -3.7, 2 * gap + 0.35 left textcolor linetype 7
set label "rolls" at -3.7, gap + 0.35 left textcolor linetype 7
set label "scrapes back" at -3.7, 0.35 left textcolor linetype 7
plot for [i = 0:2] file index i using "G_x":(column("G_y") + (2 - i) * gap) with lines linetype 6, \
     for [i = 0:2] file index i using "A_x":(column("A_y") + (2 - i) * gap) with lines linetype 1, \
     file index 0 using (column("A_x") + 0.3):(column("A_y") + 2 * gap):("{/:Italic A}") every 1::240::240 with labels left textcolor linetype 1, \
     file index 0 using (column("G_x") + 0.3):(column("G_y") + 2 * gap):("{/:Italic G}") every 1::240::240 with labels left textcolor linetype 6
