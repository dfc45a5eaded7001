load "figures/style.gp"
set logscale xy
set xrange [0.5:60]
set yrange [1e-10:100]
set xtics (0.5, 1, 2, 5, 10, 20, 60) format "%g°"
set format y "10^{%T}"
set xlabel "angle from the top, η"
set ylabel "size of the member"
set label "first" at 0.7, 22 textcolor linetype 1
set label "second" at 0.7, 0.16 textcolor linetype 3
set label "third" at 1.2, 8e-4 textcolor linetype 4
set label "left out" at 1.4, 3.5e-7 textcolor linetype 2
plot tsv("pendulum-32.sizes") using "eta":"first" with lines linetype 1, \
     "" using "eta":"second" with lines linetype 3, \
     "" using "eta":"third" with lines linetype 4, \
     "" using "eta":"rest" with lines linetype 2
