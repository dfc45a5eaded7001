load "figures/style.gp"
set logscale xy
set xrange [180:1]
set yrange [1:2e5]
set xtics (180, 90, 45, 20, 10, 5, 2, 1) format "%g°"
set ytics 10 format "10^{%T}"
set xlabel "angle from the top η"
set ylabel "terms or steps"
set label "Euler's series" at 11, 3000 right textcolor linetype 2
set label "after one step of Landen's" at 1.25, 700 right textcolor linetype 1
set label "steps of the mean" at 1.3, 2.2 right textcolor linetype 3
plot tsv("pendulum-12.counts") using "eta":"series" with lines linetype 2, \
     "" using "eta":"landen" with lines linetype 1, \
     "" using "eta":"mean" with steps linetype 3
