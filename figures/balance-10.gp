load "figures/style.gp"
file = tsv("balance-10.angles")
stats file using (y1 = column("omega"), y2 = column("eta"), y3 = column("theta")) nooutput  # the last ones
stats file using "t":"eta" nooutput
last = STATS_max_x
set xrange [0:last]
set xlabel "time (s)"
set ylabel "degrees" offset 0.5, 0
set rmargin 9
# labels at the curves' ends, at least 9 units apart
span = (STATS_max_y - STATS_min_y) * 0.07
if (abs(y2 - y1) < span) y2 = y1 + (y2 < y1 ? -span : span)
if (abs(y3 - y1) < span) y3 = y1 + (y3 < y1 ? -span : span)
if (abs(y3 - y2) < span) y3 = y2 + (y3 < y2 ? -span : span)
set label "ω, beam" at last * 1.01, y1 left textcolor linetype 4
set label "η, P" at last * 1.01, y2 left textcolor linetype 1
set label "ϑ, Q" at last * 1.01, y3 left textcolor linetype 3
plot 0 with lines linetype 6, file using "t":"eta" with lines linetype 1, \
     "" using "t":"theta" with lines linetype 3, "" using "t":"omega" with lines linetype 4
