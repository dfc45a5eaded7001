load "figures/style.gp"
set xrange [0:180]
set xtics 30 format "%g°"
set yrange [0:120]
set xlabel "amplitude ζ"
set ylabel "needed for sixteen digits" offset 0, 0
set label "terms of the series" at 122, 100 left textcolor linetype 4
set label "columns of the array" at 58, 100 right textcolor linetype 3
plot tsv("pendulum-38.needed") using "zeta":"terms" with lines linetype 4, \
     "" using "zeta":"columns" with lines linetype 3
