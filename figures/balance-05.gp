load "figures/style.gp"
set size ratio -1
unset border; unset tics; unset grid
file = tsv("balance-05.paths")
a = 16. / 9; b = 32. / 9
set xrange [-3.1:3.1]
set yrange [-4.6:0.45]
set arrow from -2.9, 0 to 2.9, 0 nohead linetype 6
set arrow from -a, 0 to a, 0 nohead linetype 7 linewidth 2.2
set arrow from -a, 0 to -a, -b nohead linetype 7
set arrow from a, 0 to a, -b nohead linetype 7
set label "{/:Italic A}" at -a, 0.22 center
set label "{/:Italic B}" at a, 0.22 center
set label "{/:Italic C}" at 0, 0.22 center
set label "{/:Italic P}" at -a, -4.4 center textcolor linetype 1
set label "{/:Italic Q}" at a, -4.4 center textcolor linetype 3
set object 1 circle at 0, 0 size 0.03 fillcolor rgb ink fillstyle solid
plot file using (-column("x")):(-column("y")) with lines linetype 1, \
     file using "x1":(-column("y1")) with lines linetype 3
