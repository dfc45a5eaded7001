short = 1
load "figures/style.gp"
set xrange [1.000472:1.000483]
set yrange [3.826725:3.826775]
set xtics 0.000004 format "%.6f"
set ytics 0.00001 format "%.5f"
set xlabel "factor"
set lmargin 12
set ylabel "product" offset -1, 0
set object 1 rectangle from 1.000472, 3.826745 to 1.000483, 3.826755 fillcolor rgb blue fillstyle solid 0.12 noborder behind
set label "rounds to 3,82675" at 1.0004822, 3.82675 right textcolor linetype 1
set label "true" at 1.0004766, 3.826741 left textcolor linetype 1
set label "in our copy" at 1.0004799, 3.8267655 right textcolor linetype 2
f = tsv("pendulum-31.factors")
plot f using "factor":"product" with lines linetype 7, \
     f every ::1::1 using "factor":"product" with points linetype 1 pointsize 0.6, \
     f every ::2::2 using "factor":"product" with points linetype 2 pointsize 0.7
