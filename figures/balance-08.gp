load "figures/style.gp"
set xrange [0:360]
set xtics 60 format "%g°"
set xlabel "time as an angle, λt"
set ylabel "outward acceleration of Q, over 2{/:Italic g}" offset 0, 0
set lmargin 11
plot 0 with lines linetype 6, \
     tsv("balance-08.accelerations") using "lambda_t":"by_III" with lines linetype 1, \
     "" using "lambda_t":"by_differences" every 5 with points linetype 2 pointsize 0.5
