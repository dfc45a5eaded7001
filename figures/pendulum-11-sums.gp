load "figures/style.gp"
set logscale x
set xrange [1:1e5]
set yrange [0.9:5.6]
set format x "10^{%T}"
set xlabel "number of terms"
set ylabel "sum of the terms"
set rmargin 8
set label "180°" at 1.2e5, 4.74 textcolor linetype 2
set label "178°" at 1.2e5, 3.46 textcolor linetype 1
set label "170°" at 1.2e5, 2.44 textcolor linetype 1
set label "150°" at 1.2e5, 1.76 textcolor linetype 1
set label "90°" at 1.2e5, 1.18 textcolor linetype 1
plot for [i = 0:3] tsv("pendulum-11.sums") index i using 1:2 with lines linetype 1, \
     "" index 4 using 1:2 with lines linetype 2 linewidth 2.2
