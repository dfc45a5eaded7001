load "figures/style.gp"
set xlabel "energy {/:Italic h}"
set ylabel "friction over pressure"
file = tsv("globe-27.needs")
stats file using "h":"mu" nooutput
end = STATS_max_x; limit = STATS_max_y
set xrange [0:end]
set yrange [0:2 * limit]
plot file using "h":"mu" with lines linetype 6, \
     file using "h":"lambda" with lines linetype 1, \
     "" using "h":"right" with lines linetype 6 dashtype 2 linewidth 1.4, \
     "" using "h":"small" with lines linetype 2, \
     "" using "h":"lambda":("needed") every ::150::150 with labels right offset -1, 0.8 textcolor linetype 1, \
     "" using "h":"right":("at 90°") every ::185::185 with labels right offset -0.6, 0.6 textcolor linetype 6, \
     "" using "h":"small":("for small {/:Italic c}") every ::150::150 with labels left offset 0.6, -0.8 textcolor linetype 2, \
     "" using "h":"mu":("the plane’s limit") every ::20::20 with labels center offset 2, 0.6 textcolor linetype 6
