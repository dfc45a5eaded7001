load "figures/style.gp"
set xrange [0:8]
set yrange [-190:190]
set ytics 90 format "%g°"
set xlabel "time, in swings of infinitely small arc"
set ylabel "angle Φ"
set label "30°" at 4.56, 31 center front boxed textcolor linetype 6
set label "90°" at 2.95, 90 center front boxed textcolor linetype 3
set label "150°" at 4.41, 150 center front boxed textcolor linetype 4
set label "179°" at 1.95, 179 center front boxed textcolor linetype 1
plot tsv("pendulum-05.motion") every :::0::0 using "swings":"phi" with lines linetype 6, \
     "" every :::1::1 using "swings":"phi" with lines linetype 3, \
     "" every :::2::2 using "swings":"phi" with lines linetype 4, \
     "" every :::3::3 using "swings":"phi" with lines linetype 1
