load "figures/style.gp"
set logscale xy
set xrange [1:150]
set yrange [0.8:2e5]
set xtics (1, 2, 5, 10, 20, 60, 120) format "%g°"
set format y "10^{%T}"
set xlabel "η"
set ylabel "terms for five decimals"
set object 1 rectangle from 6.67, 0.8 to 60, 2e5 fillcolor rgb vermilion fillstyle solid 0.08 noborder behind
set label "neither of his methods" at 20, 8e4 center textcolor linetype 2
set label "his series" at 3.2, 2.4e4 left textcolor linetype 2
set label "after one step" at 1.6, 330 left textcolor linetype 3
set label "columns" at 118, 22 left textcolor linetype 1
set label "mean, steps" at 1.1, 9 left textcolor linetype 4
plot tsv("pendulum-37.labour") using "eta":"his_series" with lines linetype 2, \
     "" using "eta":"one_step" with lines linetype 3, \
     "" using "eta":"columns" with lines linetype 1, \
     "" using "eta":"mean" with lines linetype 4
