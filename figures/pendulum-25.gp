load "figures/style.gp"
set logscale xy
set xrange [1e-8:1]
set yrange [1e-17:1e3]
set format xy "10^{%T}"
set ytics 1e4
set xlabel "v"
set ylabel "relative error"
set label "as it stands" at 1.4e-3, 1e-3 left textcolor linetype 2
set label "once reduced" at 1.3e-5, 1e-9 right textcolor linetype 5
set label "without cancellation" at 1e-6, 6e-15 center textcolor linetype 1
f = tsv("pendulum-25.error")
plot f using "v":"stands" with lines linetype 2, "" using "v":"reduced" with lines linetype 5, \
     "" using "v":"W" with lines linetype 1
