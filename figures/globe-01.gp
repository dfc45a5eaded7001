short = 1
load "figures/style.gp"
unset border
unset tics
unset grid
set size ratio -1
set xrange [-1.25:3.75]
set yrange [-1.1:1.1]
set parametric
set trange [0:2 * pi]
set label "{/:Italic C}" at -0.06, 0.12 right textcolor linetype 7
set label "plane" at 0, 0.6 center textcolor linetype 7
set label "not plane" at 2.5, 0.6 center textcolor linetype 7
plot cos(t), sin(t) with lines linetype 6, 2.5 + cos(t), sin(t) with lines linetype 6, \
     tsv("globe-01.two") using (column("x") - 1.2):(-column("G")):(2.4):(0) with vectors nohead linetype 6, \
     "" using (column("x") - 1.1 * cos(column("tilt"))):(-column("G") + 1.1 * sin(column("tilt"))):(2.2 * cos(column("tilt"))):(-2.2 * sin(column("tilt"))) with vectors nohead linetype 1, \
     "" using (column("x") + column("side")):(column("shift") - column("d")) with points linetype 7 pointsize 1.2, \
     "" using (column("x") - column("side")):(-column("shift") - column("d")) with points linetype 7 pointsize 1.2, \
     "" using "x":(0) with points linetype 7 pointsize 0.3, \
     "" using "x":(-column("G")) with points linetype 1, \
     "" using (column("x") - 0.06):(-column("G") - 0.13):("{/:Italic G}") with labels right textcolor linetype 1
