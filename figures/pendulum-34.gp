short = 1
load "figures/style.gp"
set logscale x
set xrange [0.05:60]
set yrange [0:14]
set xtics (0.1, 0.5, 1, 2, 5, 10, 20, 60) format "%g°"
set ytics 2
set xlabel "angle from the top, η"
set ylabel "terms"
set label "second example" at 0.97, 3.1 right textcolor linetype 6
set label "first" at 4.8, 4.2 right textcolor linetype 6
plot tsv("pendulum-34.terms") using "eta":"terms" with steps linetype 1, \
     tsv("pendulum-34.examples") using "eta":"terms" with impulses linetype 6
