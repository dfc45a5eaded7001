load "figures/style.gp"
curves = "globe-19.velocities"
stats tsv(curves) using "t" nooutput; end = STATS_max
stats tsv(curves) using "f" nooutput; f = STATS_max
stats tsv(curves) using "v" nooutput; high = STATS_max; low = STATS_min
set xlabel "time (seconds)"
set ylabel "velocity (ft/s)"
set xrange [0:end]
set yrange [low - 0.2 * (high - low):high + 0.1 * (high - low)]
set label "{/:Italic C}" at 0, high left offset 3.5, 0 textcolor linetype 1
set label "{/:Italic G}" at 0, f left offset 2, -0.7 textcolor linetype 7
plot tsv(curves) using "t":"f" with lines linetype 7, \
     "" using "t":"v" with lines linetype 1
