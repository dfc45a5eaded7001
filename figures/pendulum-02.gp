load "figures/style.gp"
set size ratio -1
set margins 1, 1, 0.5, 0.5
unset border
unset tics
unset grid
set xrange [-0.95:0.95]
set yrange [-1.18:0.12]
set label "A" at 0, 0.05 center textcolor rgb ink
set label "B" at 0, -1.055 center textcolor rgb ink
set label "G" at 0.675, -0.75 left textcolor rgb ink
set label "H" at 0.675, -1.0 left textcolor rgb ink
set label "ζ" at 0.105, -0.34 center textcolor rgb blue
set label at 0, 0 "" point linetype 7 pointsize 0.7
plot tsv("pendulum-02.fig_1") every :::0::0 using "x":"y" with lines linetype 7, \
     "" every :::1::1 using "x":"y" with lines linetype 7 linewidth 2.2, \
     "" every :::2::2 using "x":"y" with lines linetype 6 dashtype (6, 4), \
     "" every ::0:3:0:3 using "x":"y":(0):(-0.22) with vectors linetype 7, \
     "" every :::4::4 using "x":"y" with lines linetype 6, \
     "" every :::5::5 using "x":"y" with lines linetype 1, \
     "" every ::1:1:1:1 using "x":"y" with points linetype 7 pointsize 0.9
