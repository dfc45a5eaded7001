load "figures/style.gp"
set xlabel "μ{/:Italic t}"
set ylabel "η, in parts of 𝔄"
set xrange [0:50]
set arrow from 4, 1.45 to 4, 0.05 linetype 6 head filled size screen 0.01, 20
set arrow from 0, 0 to 50, 0 nohead linetype 6
set label "the true motion: rest" at 1, 1.6 left textcolor linetype 6
plot tsv("balance-27.nothing") using "t":"eta" with lines linetype 2
