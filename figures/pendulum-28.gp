load "figures/style.gp"
set logscale y
set xrange [0:30]
set yrange [1e-16:1]
set format y "10^{%T}"
set ytics 1e4
set xlabel "columns beside the logarithmic one"
set ylabel "relative error"
set arrow from 2, 1e-16 to 2, 1 nohead linetype 6
set label "Euler" at 2.3, 3e-16 left textcolor linetype 6
set label "2½°" at 5.3, 1e-14 left textcolor linetype 1
set label "10°" at 9.5, 1e-14 left textcolor linetype 1
set label "30°" at 20, 2e-12 left textcolor linetype 1
set label "α = 45°" at 25, 3e-8 left textcolor linetype 1
f = tsv("pendulum-28.lacking")
plot for [i = 2:5] f using 1:i with linespoints linetype 1 pointsize 0.35
