load "figures/style.gp"
curves = "globe-22.centre"
stats tsv(curves) using "exact" nooutput; low = STATS_max
stats tsv(curves) using "exact_slow" nooutput; high = STATS_max
top = low > high ? low : high
set xlabel "time, in turns"
set ylabel "ahead of even turning (degrees)" offset 0, 0
set xrange [0:1]
set yrange [-1.2 * top:1.2 * top]
set label "{/:Italic n} = 1.6" at 0.25, high center offset 0, 0.8 textcolor linetype 7
set label "this ball" at 0.25, low center offset 0, 0.8 textcolor linetype 1
set label "by Euler’s formula" at graph 0.98, graph 0.95 right textcolor linetype 2
plot tsv(curves) using "x":"exact_slow" with lines linetype 7, \
     "" using "x":"euler_slow" with lines linetype 2 dashtype (6, 4), \
     "" using "x":"exact" with lines linetype 1, \
     "" using "x":"euler" with lines linetype 2 dashtype (6, 4)
