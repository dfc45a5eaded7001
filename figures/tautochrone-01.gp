load "figures/style.gp"
set logscale xy
set xrange [0.1:120]
set yrange [0.01:40000]
set xtics ("0.1°" 0.1, "1°" 1, "5°" 5, "30°" 30, "90°" 90)
set ytics ("0.01" 0.01, "0.1" 0.1, "1" 1, "10" 10, "100" 100, "1000" 1000, "10 000" 10000)
set xlabel "amplitude φ_0"
set ylabel "seconds a day late"
set label "in a circle" at 40, 9000 right textcolor linetype 1
set label "86400 φ_0^2/16" at 1.1, 1 left textcolor linetype 6
plot tsv("tautochrone-01.losses") using "phi0":"law" with lines linetype 6, \
     "" using "phi0":"late" with lines linetype 1
