load "figures/style.gp"
set xrange [0:90]
set xtics 15 format "%g°"
set yrange [0:8]
set xlabel "η, from the top to where the descent begins"
set ylabel "T / Θ"
set label "as printed" at 46, 2.75 left textcolor linetype 2
set label "exact" at 62, 1.75 left textcolor linetype 1
set label "with 2/π" at 84, 0.72 center textcolor linetype 3
plot tsv("pendulum-29.laws") using "eta":"printed" with lines linetype 2, \
     "" using "eta":"mended" with lines linetype 3 dashtype (8, 5) linewidth 2.4, \
     "" using "eta":"exact" with lines linetype 1
