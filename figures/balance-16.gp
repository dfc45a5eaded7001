load "figures/style.gp"
file = tsv("balance-16.steps")
stats file using "t":"none" nooutput name "N"
stats file using "t":"in_step" nooutput name "S"
set logscale xy
set xrange [N_min_x:N_max_x]
set yrange [S_min_y / 3:3 * N_max_y]
set format y "10^{%T}"
set xlabel "time (s)"
set ylabel "greatest error" offset 0, 0
set lmargin 10
set label "left out" at 20, 0.028 left textcolor linetype 6
set label "put in once" at 45, 1.8e-3 right textcolor linetype 2
set label "and μ put right" at 250, 5e-5 left textcolor linetype 1
plot file using "t":"none" with lines linetype 6 linewidth 1.6, \
     file using "t":"once" with lines linetype 2, \
     file using "t":"in_step" with lines linetype 1
