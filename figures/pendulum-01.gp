load "figures/style.gp"
set xrange [0:120]
set yrange [0:40]
set xtics 20 format "%g°"
set format y "%g %%"
set xlabel "amplitude ζ"
set ylabel "correction"
set label "for the body, √(b/a) − 1" at 4, 17.2 left textcolor linetype 3
set label "for the arc, T/Θ − 1" at 98, 25.5 right textcolor linetype 1
plot tsv("pendulum-01.corrections") using "zeta":"body" with lines linetype 3, \
     "" using "zeta":"arc" with lines linetype 1
