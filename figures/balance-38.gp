load "figures/style.gp"
set xlabel "{/:Italic t} (seconds)"
set ylabel "inclination, in parts of P's first"
set xrange [0:12 * pi]
set yrange [-2.6:2.6]
set ytics ("1" 2.3, "0" 1.3, "−1" 0.3, "1" -0.3, "0" -1.3, "−1" -2.3)
set rmargin 4
set label "P" at graph 1.02, first 1.3 left textcolor linetype 1
set label "Q" at graph 1.02, first -1.3 left textcolor linetype 3
file = tsv("balance-38.pans")
plot file using "t":(column("eta") + 1.3) with lines linetype 1, \
     "" using "t":(column("of_P") + 1.3) with lines linetype 6 dashtype (6, 4), \
     "" using "t":(1.3 - column("of_P")) with lines linetype 6 dashtype (6, 4), \
     "" using "t":(column("theta") - 1.3) with lines linetype 3, \
     "" using "t":(column("of_Q") - 1.3) with lines linetype 6 dashtype (6, 4), \
     "" using "t":(-1.3 - column("of_Q")) with lines linetype 6 dashtype (6, 4)
