load "figures/style.gp"
set xrange [0:4 * pi]
set yrange [-0.45:0.45]
set xlabel "{/:Italic t} (seconds)"
set ylabel "inclination (degrees)"
set arrow from 0, 0 to 4 * pi, 0 nohead linetype 2
set label "Euler: at rest" at 5.05, 0.2 left textcolor linetype 2
set label "P" at 3.15, -0.37 center textcolor linetype 1
set label "Q" at 3.15, 0.37 center textcolor linetype 3
plot tsv("balance-28.pans") using "t":"theta" with lines linetype 3, \
     "" using "t":"eta" with lines linetype 1, \
     "" using "t":"second" with lines linetype 6 dashtype (6, 4)
