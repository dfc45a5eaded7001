load "figures/style.gp"
set xrange [0:360]
set xtics 60 format "%g°"
set xlabel "time as an angle, λt"
set ylabel "moment on the beam (ft)" offset 0, 0
set lmargin 11
file = tsv("balance-09.moments")
stats file using "lambda_t":"weight" nooutput
m = STATS_max_y
set yrange [-1.35 * m:1.35 * m]
set label "its own weight" at 180, 1.12 * m center textcolor linetype 1
set label "both strings" at 180, -0.64 * m center textcolor linetype 3
set label "all" at 180, 0.28 * m center textcolor linetype 4
plot 0 with lines linetype 6, file using "lambda_t":"weight" with lines linetype 1, \
     "" using "lambda_t":"strings" with lines linetype 3, "" using "lambda_t":"all" with lines linetype 4
