tall = 1
load "figures/style.gp"
set size ratio -1
set margins 1, 1, 0.5, 0.5
unset border
unset tics
unset grid
set xrange [-1.2:1.3]
set yrange [-1.15:1.15]
plate = tsv("pendulum-13.plate")
set label "A" at -0.07, -0.02 right
set label "B" at 0, -1.08 center
set label "b" at 0, 1.07 center
plot plate every :::0::0 using "x":"y" with lines linetype 6, \
     plate every :::7::7 using "x":"y" with lines linetype 1 linewidth 2.6, \
     plate every :::1::3 using "x":"y" with lines linetype 7, \
     plate every :::4::4 using "x":"y" with lines linetype 2, \
     plate every :::5::5 using "x":"y" with lines linetype 1, \
     plate every :::6::6 using "x":"y" with lines linetype 6, \
     plate every ::1:2:1:3 using "x":"y" with points linetype 7 pointsize 0.8, \
     plate every ::0:1:0:3 using "x":"y" with points linetype 7 pointsize 0.8, \
     plate every ::50:4:50:4 using (1.13 * $1):(1.13 * $2):("η") with labels textcolor linetype 2, \
     plate every ::50:5:50:5 using (1.2 * $1):(1.2 * $2):("ψ") with labels textcolor linetype 1, \
     plate every ::50:6:50:6 using (1.4 * $1):(1.4 * $2):("Φ") with labels textcolor linetype 7, \
     plate every ::1:2:1:2 using (1.09 * $1):(1.09 * $2):("g") with labels, \
     plate every ::1:3:1:3 using (1.08 * $1):(1.08 * $2):("Z") with labels
