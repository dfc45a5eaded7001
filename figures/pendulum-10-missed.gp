load "figures/style.gp"
set logscale xy
set xrange [0.1:180]
set yrange [1e-13:10]
set xtics (0.1, 0.3, 1, 3, 10, 30, 90, 180) format "%g°"
set ytics 1e3 format "10^{%T}"
set rmargin 5
set xlabel "amplitude ζ"
set ylabel "in units of Θ" offset -0.5, 0
set label "T/Θ − 1" at 0.7, 3e-4 textcolor linetype 1
set label "missed by the rule" at 3, 1e-9 textcolor linetype 2
set label "bounds" at 60, 3 right textcolor linetype 6
plot tsv("pendulum-10.corrections") using "zeta":"least" with lines linetype 6, \
     "" using "zeta":"most" with lines linetype 6, \
     "" using "zeta":"excess" with lines linetype 1, \
     "" using "zeta":"missed" with lines linetype 2
