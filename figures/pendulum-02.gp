load "figures/style.gp"
set size ratio -1
set margins 1, 1, 0.5, 0.5
unset border
unset tics
unset grid
stats tsv("pendulum-02.fig_1") using "x":"y" nooutput
wide = STATS_max_x + 0.31 > 0.95 ? STATS_max_x + 0.31 : 0.95
set xrange [-wide:wide]
set yrange [-1.18:(STATS_max_y > 0 ? STATS_max_y : 0) + 0.12]
set label "A" at 0, 0.05 center textcolor rgb ink
set label "B" at 0, -1.055 center textcolor rgb ink
set label at 0, 0 "" point linetype 7 pointsize 0.7
plot tsv("pendulum-02.fig_1") every :::0::0 using "x":"y" with lines linetype 7, \
     "" every :::1::1 using "x":"y" with lines linetype 7 linewidth 2.2, \
     "" every :::2::2 using "x":"y" with lines linetype 6 dashtype (6, 4), \
     "" every ::0:3:0:3 using "x":"y":(0):(-0.22) with vectors linetype 7, \
     "" every :::4::4 using "x":"y" with lines linetype 6, \
     "" every :::5::5 using "x":"y" with lines linetype 1, \
     "" every ::1:1:1:1 using "x":"y" with points linetype 7 pointsize 0.9, \
     "" every ::1:1:1:1 using (column("x") + 0.032):(column("y") + 0.016):("G") with labels left textcolor rgb ink, \
     "" every ::1:3:1:3 using (column("x") + 0.032):(column("y") - 0.014):("H") with labels left textcolor rgb ink, \
     "" every ::15:5:15:5 using (1.25 * column("x")):(1.25 * column("y")):("ζ") with labels textcolor rgb blue
