load "figures/style.gp"
set xlabel "time, in single swings"
set ylabel "exact Φ less Euler’s (% of amplitude)"
set xrange [0:4]
set label "exactly" at graph 0.06, graph 0.93 left textcolor linetype 1
set label "by the next term" at graph 0.06, graph 0.86 left textcolor linetype 2
plot tsv("globe-14.error") using "swings":(100 * column("exact")) with lines linetype 1, \
     "" using "swings":(100 * column("next")) with lines linetype 2 dashtype (6, 4)
