load "figures/style.gp"
set xlabel "energy {/:Italic h}"
set ylabel "friction over pressure"
file = tsv("globe-27.needs")
stats file using "h":"mu" nooutput
end = STATS_max_x; limit = STATS_max_y
set xrange [0:end]
stats file using "lambda" every ::150::150 name "A" nooutput
stats file using "small" every ::150::150 name "B" nooutput
stats file using "right" every ::185::185 name "C" nooutput
more(x, y) = x > y ? x : y
top = more(2 * limit, 1.3 * more(A_max, more(B_max, C_max)))
set yrange [0:top]
within(name) = column(name) <= top ? column(name) : NaN   # what is needed grows without bound
plot file using "h":"mu" with lines linetype 6, \
     file using "h":(within("lambda")) with lines linetype 1, \
     "" using "h":(within("right")) with lines linetype 6 dashtype 2 linewidth 1.4, \
     "" using "h":(within("small")) with lines linetype 2, \
     "" using "h":"lambda":("needed") every ::150::150 with labels right offset -1, 0.8 textcolor linetype 1, \
     "" using "h":"right":("at 90°") every ::185::185 with labels right offset -0.6, 0.6 textcolor linetype 6, \
     "" using "h":"small":("for small {/:Italic c}") every ::150::150 with labels left offset 0.6, -0.8 textcolor linetype 2, \
     "" using "h":"mu":("the plane’s limit") every ::20::20 with labels center offset 2, 0.6 textcolor linetype 6
