load "figures/style.gp"
set xlabel "time (s)"
set ylabel "Φ (degrees)"
file = tsv("globe-28.motion")
stats file using "t":"rolling" nooutput
set xrange [0:STATS_max_x]
plot file using "t":"smooth" with lines linetype 6 linewidth 1.4, \
     file using "t":"rolling" with lines linetype 1, \
     file using "t":"smooth":("smooth plane") every ::86::86 with labels left offset 1, 0.4 textcolor linetype 6, \
     file using "t":"rolling":("rolling") every ::46::46 with labels left offset 1, 0.4 textcolor linetype 1
