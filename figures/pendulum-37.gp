load "figures/style.gp"
set logscale xy
set xrange [1:150]
set yrange [1e-9:10]
set xtics (1, 2, 5, 10, 20, 60, 120) format "%g°"
set format y "10^{%T}"
set xlabel "angle from the top, η"
set ylabel "left out of {/:Italic K}" offset 0, 0
set label "five decimals" at 1.1, 1.6e-5 left textcolor linetype 6
set label "three members" at 1.1, 6e-7 left textcolor linetype 3
set label "four members" at 4.3, 3e-9 right textcolor linetype 3
set label "his series, 1000 terms" at 4.4, 0.02 right textcolor linetype 4
set label "100 terms" at 13, 0.02 right textcolor linetype 4
set label "10 terms" at 24.5, 0.2 right textcolor linetype 4
plot 0.5e-5 with lines linetype 6, \
     tsv("pendulum-37.methods") using "eta":"three" with lines linetype 3, \
     "" using "eta":"four" with lines linetype 3 dashtype (6, 3), \
     "" using "eta":"s10" with lines linetype 4, \
     "" using "eta":"s100" with lines linetype 4, \
     "" using "eta":"s1000" with lines linetype 4
