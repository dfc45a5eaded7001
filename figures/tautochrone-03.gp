load "figures/style.gp"
set logscale xy
set xrange [1:90]
set yrange [0.001:30000]
set xtics ("1°" 1, "5°" 5, "10°" 10, "30°" 30, "90°" 90)
set ytics ("0.001" 0.001, "0.01" 0.01, "0.1" 0.1, "1" 1, "10" 10, "100" 100, "1000" 1000, "10 000" 10000)
set xlabel "amplitude φ_0"
set ylabel "seconds a day late"
set label "circle" at 4.6, 60 right textcolor linetype 2
set label "{/:Italic k} = 0.3 {/:Italic a}" at 6, 9 left rotate by 16 textcolor linetype 1
set label "0.1 {/:Italic a}" at 6, 1.07 left rotate by 16 textcolor linetype 1
set label "0.02 {/:Italic a}" at 6, 0.043 left rotate by 16 textcolor linetype 1
plot tsv("tautochrone-03.losses") using "phi0":"circle" with lines linetype 2, \
     "" using "phi0":"k30" with lines linetype 1, \
     "" using "phi0":"k10" with lines linetype 1, \
     "" using "phi0":"k02" with lines linetype 1
