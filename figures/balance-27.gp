load "figures/style.gp"
set xlabel "{/:Italic μt}"
set ylabel "inclination η"
set xrange [0:50]
set arrow from 0, 0 to 50, 0 nohead linetype 6
set label "at rest" at graph 0.02, graph 0.08 left textcolor linetype 6
plot tsv("balance-27.nothing") using "t":"eta" with lines linetype 2
