load "figures/style.gp"
set xlabel "angular velocity (1/s)"
set ylabel "λ, friction over pressure"
stats tsv("globe-24.by_velocity") using "w":"lower" nooutput
last = STATS_max_x; most = STATS_max_y; end = STATS_records - 1
set xrange [0:last]
low = -5 * most
set yrange [low:1.6 * most]
# A curve that runs away ends where it meets the frame.
w0 = 0; value0 = 0
across(w, value) = value > low ? w : value0 > low ? w0 + (low - value0) / (value - value0) * (w - w0) : NaN
down(w, value) = (ends = value > low ? value : value0 > low ? low : NaN, w0 = w, value0 = value, ends)
set rmargin 7
plot 0 with lines linetype 6, \
     tsv("globe-24.by_velocity") using "w":"lower" with lines linetype 1, \
     "" using (across(column("w"), column("upper"))):(down(column("w"), column("upper"))) with lines linetype 3, \
     "" using (last):"lower":("60°") every ::end::end with labels left offset 0.6, 0 textcolor linetype 1, \
     "" using "w":"upper":("120°") every ::30::30 with labels right offset -1, -0.6 textcolor linetype 3
