load "figures/style.gp"
set xrange [0:24]
set xtics 4
set logscale y
set yrange [1e-20:1e4]
set format y "10^{%T}"
set rmargin 6
set xlabel "n, where k^{2n} is the last power kept"
set ylabel "error of r / a"
set arrow from 2, graph 0 to 2, graph 0.94 nohead linetype 6
set label "Euler" at 2, graph 0.97 center textcolor linetype 6
set label "50°" at 19.5, 1e3 right textcolor linetype 1
set label "40°" at 24.4, 1e-4 left textcolor linetype 1
set label "30°" at 24.4, 5e-12 left textcolor linetype 1
set label "20°" at 24.4, 2e-20 left textcolor linetype 1
set label "10°" at 13.1, 1e-19 right textcolor linetype 1
plot for [angle in "10 20 30 40 50"] tsv("tautochrone-30.orders") using "n":"at".angle \
     with linespoints linetype 1 pointsize 0.4
