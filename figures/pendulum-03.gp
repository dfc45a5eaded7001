load "figures/style.gp"
stats tsv("pendulum-03.body") every ::3::3 using "x" name "X" nooutput
stats tsv("pendulum-03.body") every ::3::3 using "y" name "Y" nooutput
stats tsv("pendulum-03.body") every ::3::3 using "size" name "K" nooutput
gx = X_min; gy = Y_min; k = K_min
set size ratio -1
set margins 1, 1, 0.5, 0.5
unset border
unset tics
unset grid
set xrange [-1.7:1.7]
set yrange [-2.5:0.25]
set label at 0, 0 "" point linetype 7 pointsize 0.7
set arrow from 0, 0 to gx, gy nohead linetype 7 linewidth 2.2
set object circle at gx, gy size k fillstyle empty border rgb blue
set arrow from gx, gy to gx - k, gy nohead linetype 1
set label "A" at -0.1, 0.07 right
set label "G" at gx + 0.07, gy + 0.12 left
set label "a" at gx / 2 + 0.1, gy / 2 left
set label "k" at gx - k / 2, gy - 0.13 center textcolor linetype 1
set label "the whole mass, spread here" at gx - 1.05 * k, gy - 0.8 * k right textcolor linetype 1
plot tsv("pendulum-03.body") every ::0::2 using (gx):(gy):(column("x") - gx):(column("y") - gy) with vectors nohead linetype 6, \
     "" every ::0::2 using "x":"y":(2.2 * column("size")) with points linetype 7 pointsize variable, \
     "" every ::3::3 using "x":"y" with points linetype 7 pointsize 0.7
