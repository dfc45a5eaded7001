load "figures/style.gp"
file = tsv("balance-32.swings")
stats file using "t":"P" name "P" nooutput
stats file using "t":"Q" name "Q" nooutput
set xrange [0:P_max_x]
top = (P_max_y > Q_max_y ? P_max_y : Q_max_y)
set yrange [0:1.15 * top]
stats file using "P" every ::299::299 name "LP" nooutput
stats file using "Q" every ::299::299 name "LQ" nooutput
set rmargin 4
set xlabel "time (seconds)"
set ylabel "swing (degrees)"
set label "P" at graph 1.01, first LP_max left textcolor linetype 1
set label "Q" at graph 1.01, first LQ_max left textcolor linetype 3
plot file using "t":"P" with lines linetype 1, file using "t":"Q" with lines linetype 3, \
     file using "t":"P_theory" with lines linetype 6 dashtype (6, 4), \
     file using "t":"Q_theory" with lines linetype 6 dashtype (6, 4)
