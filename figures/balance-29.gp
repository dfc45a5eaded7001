load "figures/style.gp"
file = tsv("balance-29.other")
stats file using "t":"full" name "Q" nooutput
set xrange [0:Q_max_x]
set xlabel "{/:Italic t} (seconds)"
set ylabel "inclination of Q (degrees)"
set arrow from graph 0, first 0 to graph 1, first 0 nohead linetype 2
set label "Euler" at graph 1.01, first 0 left textcolor linetype 2
set rmargin 7
plot file using "t":"full" with lines linetype 1, file using "t":"second" with lines linetype 6 dashtype (6, 4)
