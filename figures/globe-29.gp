load "figures/style.gp"
set xlabel "energy {/:Italic h}"
set ylabel "single swing, or turn (s)"
set xrange [0:3]
stats tsv("globe-29.times") using "h":"rolling" nooutput
set yrange [0:0.75 * STATS_max_y]
set arrow from 1, graph 0 to 1, graph 1 nohead linetype 6 dashtype 2
plot tsv("globe-29.smooth") using "h":"smooth" with lines linetype 6 linewidth 1.4, \
     tsv("globe-29.times") using "h":"rolling" with lines linetype 1, \
     tsv("globe-29.times") using "h":"rolling":("rolling") every ::140::140 with labels left offset 0.6, 0.6 textcolor linetype 1, \
     tsv("globe-29.smooth") using "h":"smooth":("smooth plane") every ::158::158 with labels right offset 0, -0.8 textcolor linetype 6
