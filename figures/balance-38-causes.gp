load "figures/style.gp"
set logscale x
set xlabel "time (seconds)"
set ylabel "Q's swing, in parts of P's first"
set xrange [1:2000]
set yrange [0:1.25]
set label "{/:Italic C} can move" at 14, 1.09 center textcolor linetype 1
set label "the beam\nswings" at 330, 1.17 center textcolor linetype 3
set label "{/:Italic A} and {/:Italic B}\nlower" at 1250, 1.17 center textcolor linetype 4
file = tsv("balance-38.ways")
plot file index 0 using "t":"Q" with lines linetype 1, \
     file index 1 using "t":"Q" with lines linetype 3, \
     file index 2 using "t":"Q" with lines linetype 4
