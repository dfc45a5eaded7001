load "figures/style.gp"
file = tsv("balance-03.particles")
set logscale xy
set format y "10^{%L}"
set xrange [1:1024]
set xtics (1, 4, 16, 64, 256, 1024)
set xlabel "particles {/:Italic N} in each arm and in the tongue"
set ylabel "missing part" offset -0.5, 0
set lmargin 11
stats file using "N":"about_C" nooutput
set label "moment of inertia about {/:Italic C}: one part in 4{/:Italic NN}" at 9, STATS_max_y * 0.03 left textcolor linetype 1
plot file using "N":"about_C" with linespoints linetype 1
