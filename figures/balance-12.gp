load "figures/style.gp"
file = tsv("balance-12.pulls")
stats file using "lambda_t":"exact" nooutput
low = STATS_min_y; high = STATS_max_y; d = high - low
set xrange [0:360]
set xtics 60 format "%g°"
set yrange [low - 0.12 * d:high + 0.3 * d]
set xlabel "time as an angle, λt"
set ylabel "{/:Italic P} in weights of the pan" offset 0, 0
set lmargin 11
set label "exactly" at (STATS_pos_max_y < 25 ? 25 : STATS_pos_max_y > 335 ? 335 : STATS_pos_max_y), high + 0.07 * d \
  center textcolor linetype 1
set label "points: the second order, (A)" at 180, high + 0.2 * d center textcolor linetype 3
set label "Euler, (2)" at 300, high + 0.2 * d center textcolor linetype 2
plot file using "lambda_t":"exact" with lines linetype 1, "" using "lambda_t":"second" every 12 with points linetype 3, \
     "" using "lambda_t":"first" with lines linetype 2
