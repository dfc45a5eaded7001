load "figures/style.gp"
set xrange [0:360]
set xtics 60 format "%g°"
set yrange [-0.5:1.3]
set xlabel "time as an angle, λt"
set ylabel "in weights of the pan"
set label "upward, {/:Italic P} cos η" at 300, 1.22 center textcolor linetype 1
set label "towards {/:Italic C}, {/:Italic P} sin η" at 190, 0.46 right textcolor linetype 3
plot 1 with lines linetype 6, 0 with lines linetype 6, \
     tsv("balance-07.forces") using "lambda_t":"upward" with lines linetype 1, \
     "" using "lambda_t":"inward" with lines linetype 3
