load "figures/style.gp"
set xlabel "angular velocity (1/s)"
set ylabel "λ, friction over pressure"
stats tsv("globe-24.by_velocity") using "w":"lower" nooutput
last = STATS_max_x; most = STATS_max_y; end = STATS_min_y
set xrange [0:last]
set yrange [-5 * most:1.6 * most]
set lmargin 9
set ylabel offset -1, 0
set rmargin 7
plot 0 with lines linetype 6, \
     tsv("globe-24.by_velocity") using "w":"lower" with lines linetype 1, \
     "" using "w":"upper" with lines linetype 3, \
     "" using (last):"lower":("60°") every ::60::60 with labels left offset 0.6, 0 textcolor linetype 1, \
     "" using "w":"upper":("120°") every ::30::30 with labels right offset -1, -0.6 textcolor linetype 3
