load "figures/style.gp"
set logscale y
set xrange [0:180]
set xtics 30 format "%g°"
set yrange [1:2e5]
set ytics 10 format "10^{%T}"
set xlabel "amplitude ζ"
set ylabel "terms or steps"
set label "Euler's series" at 140, 400 right textcolor linetype 2
set label "after one step of Landen's" at 117, 5.6 right textcolor linetype 1
set label "steps of the mean" at 100, 2 left textcolor linetype 3
plot tsv("pendulum-12.needed") using "zeta":"series" with steps linetype 2, \
     "" using "zeta":"landen" with steps linetype 1, \
     "" using "zeta":"mean" with steps linetype 3
