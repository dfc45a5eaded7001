load "figures/style.gp"
stats tsv("balance-23.beam") using "t":"full" name "W" nooutput
set xrange [0:W_max_x]
set xlabel "{/:Italic t} (seconds)"
set ylabel "inclination of the beam (degrees)"
set arrow from graph 0, first 0 to graph 1, first 0 nohead linetype 2
set rmargin 8
set label "Euler" at graph 1.01, first 0 left textcolor linetype 2
plot tsv("balance-23.beam") using "t":"full" with lines linetype 1, \
     "" using "t":"second" with lines linetype 6 dashtype (6, 4)
