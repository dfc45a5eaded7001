load "figures/style.gp"
set xrange [-190:190]
set yrange [-2.3:2.3]
set xtics 90 format "%g°"
set ytics 1
set xlabel "angle Φ"
set ylabel "angular speed"
set label "30°" at 0, 0.66 center textcolor linetype 1
set label "60°" at 0, 1.13 center textcolor linetype 1
set label "90°" at 0, 1.54 center textcolor linetype 1
set label "150°" at 143, 0.14 right textcolor linetype 1
set label "180°" at 92, 1.66 left textcolor linetype 2
plot for [i = 0:3] tsv("pendulum-06.phase") every :::i::i using "phi":"rate" with lines linetype 1, \
     "" every :::4::4 using "phi":"rate" with lines linetype 2 linewidth 2.2
