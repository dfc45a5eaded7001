load "figures/style.gp"
stats tsv("pendulum-33.ends") using "euler" nooutput  # the later end
set xrange [0:1.1 * STATS_max]
set yrange [-190:190]
set ytics 90 format "%g°"
set xlabel "time (seconds)"
set ylabel "angle from the lowest point" offset 0, 0
plot tsv("pendulum-33.ends") using "exact":(-column("turn")):(0):(2 * column("turn")) with vectors nohead linetype 6, \
     "" using "euler":(-column("turn")):(0):(2 * column("turn")) with vectors nohead linetype 2 dashtype (6, 4), \
     "" using "exact":(-120):(sprintf("end of the swing, %.2f s  ", column("exact"))) with labels right textcolor linetype 1, \
     "" using "euler":(-160):(sprintf("Euler's end, %.2f s  ", column("euler"))) with labels right textcolor linetype 2, \
     tsv("pendulum-33.swing") using "seconds":"angle" with lines linetype 1 linewidth 2
