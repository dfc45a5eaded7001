load "figures/style.gp"
set xrange [0:5]
set yrange [-190:190]
set ytics 90 format "%g°"
set xlabel "seconds"
set ylabel "angle from the lowest point"
set arrow 1 from 4.52023, -175 to 4.52023, 175 nohead linetype 2 dashtype (6, 4)
set label "4,52 s, Euler" at 4.47, -100 right textcolor linetype 2
set arrow 2 from 2.87766, -175 to 2.87766, 175 nohead linetype 6
set label "2,88 s" at 2.93, -100 left textcolor linetype 1
plot 175 with lines linetype 6 dashtype (2, 4), -175 with lines linetype 6 dashtype (2, 4), \
     tsv("pendulum-33.swing") using "seconds":"angle" with lines linetype 1 linewidth 2
