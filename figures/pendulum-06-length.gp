short = 1
load "figures/style.gp"
set logscale x
set xrange [0.1:10]
set yrange [0:10.2]
set ytics 2
set xtics ("0.1" 0.1, "0.2" 0.2, "½" 0.5, "1" 1, "2" 2, "5" 5, "10" 10)
set xlabel "a / k"
set ylabel "b / k"
set arrow from 0.5, 2.5 to 2, 2.5 nohead linetype 6
set arrow from 0.5, 0 to 0.5, 2.5 nohead linetype 6
set arrow from 2, 0 to 2, 2.5 nohead linetype 6
set label "the same b" at 1, 3.3 center textcolor linetype 6
plot tsv("pendulum-06.length") using "a":"b" with lines linetype 1
