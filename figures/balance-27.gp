load "figures/style.gp"
set xlabel "μ{/:Italic t}"
set ylabel "inclination η"
set xrange [0:50]
set arrow from 0, 0 to 50, 0 nohead linetype 6
set label "the true motion: rest" at 0.5, -0.4 left textcolor linetype 6
plot tsv("balance-27.nothing") using "t":"eta" with lines linetype 2
