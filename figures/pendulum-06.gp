load "figures/style.gp"
set xrange [-190:190]
set yrange [-2.3:2.3]
set xtics 90 format "%g°"
set ytics 1
set xlabel "angle Φ"
set ylabel "angular speed, in √(2g/b)"
set label "30°" at 0, 0.5176 center front boxed textcolor linetype 1
set label "60°" at 0, 1 center front boxed textcolor linetype 1
set label "90°" at 0, 1.4142 center front boxed textcolor linetype 1
set label "150°" at 150, 0 center front boxed textcolor linetype 1
set label "180°, the separatrix" at 92, 1.66 left textcolor linetype 6
plot for [i = 0:3] tsv("pendulum-06.phase") every :::i::i using "phi":"rate" with lines linetype 1, \
     "" every :::4::4 using "phi":"rate" with lines linetype 6 linewidth 1.8
