load "figures/style.gp"
set size ratio -1
set margins 1, 1, 0.5, 0.5
unset border
unset tics
unset grid
set xrange [-0.6:1.3]
set yrange [-1.1:0.1]
set label "A" at 0, 0.05 center
set label "B" at 0, -1.055 center
set label "G" at 0.64, -0.83 center
set label "g" at 0.745, -0.73 center
set label "Φ" at 0.1, -0.32 center textcolor linetype 1
set label "dΦ" at 0.40, -0.345 left textcolor linetype 1
set label at 0, 0 "" point linetype 7 pointsize 0.7
plot tsv("pendulum-05.fig_2") every :::0::0 using "x":"y" with lines linetype 7, \
     "" every :::1::1 using "x":"y" with lines linetype 7 linewidth 2.2, \
     "" every :::2::2 using "x":"y" with lines linetype 7, \
     "" every :::3::3 using "x":"y" with lines linetype 6, \
     "" every :::4::4 using "x":"y" with lines linetype 1, \
     "" every :::5::5 using "x":"y" with lines linetype 1 linewidth 3, \
     "" every ::1:1:1:2 using "x":"y" with points linetype 7 pointsize 0.8
