load "figures/style.gp"
curves = "globe-21.means"
stats tsv("globe-21.limit") using "n" nooutput; edge = STATS_max
stats tsv(curves) using "silent" nooutput; top = STATS_max; last = STATS_min
stats tsv(curves) using "named" nooutput; first = STATS_max; named = STATS_min
stats tsv(curves) using "root" nooutput; root = STATS_min
set xlabel "{/:Italic n}"
set ylabel "left out of a turn" offset 0, 0
set logscale xy
set lmargin 10
set rmargin 17
set format y "10^{%L}"
set xtics (1.5, 2, 3, 5, 10, 20, 30)
low = (root < last ? root : last) / 3
set xrange [1.5:30]
set yrange [low:3 * (first > top ? first : top)]
set label "not mentioned" at 30, last left offset 0.5, 0 textcolor linetype 2
set label "named" at 30, named left offset 0.5, 0 textcolor linetype 1
set label "of the root" at 30, root left offset 0.5, 0 textcolor linetype 3
if (edge > 1.5 && edge < 30) set arrow from edge, graph 0 to edge, graph 1 nohead linetype 6
if (edge > 1.5 && edge < 30) set label "on the plane" at edge, graph 0.95 right offset -0.5, 0 textcolor linetype 6
if (edge > 1.5 && edge < 30) set label "off it" at edge, graph 0.95 left offset 0.5, 0 textcolor linetype 6
plot tsv(curves) using "n":"silent" with lines linetype 2, \
     "" using "n":"named" with lines linetype 1, \
     "" using "n":"root" with lines linetype 3
