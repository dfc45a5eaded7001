load "figures/style.gp"
set xrange [0:360]
set xtics 60 format "%g°"
set mxtics 2
set yrange [-24:24]
set ytics 10
set lmargin 9
set format y "%g′"
set xlabel "time as an angle, λt"
set ylabel "strays from a regular swing" offset 0, 0
set label "P" at 258, 19.3 center textcolor linetype 1
set label "Q" at 171, 21.7 center textcolor linetype 3
set label "by (1)" at 66, 10.8 center textcolor linetype 2
plot tsv("balance-36.strays") using "angle":"by_1_eta" with lines linetype 2 linewidth 0.8, \
     "" using "angle":"by_1_theta" with lines linetype 2 linewidth 0.8, \
     "" using "angle":"by_1_eta" every 30 with points linetype 2 pointsize 0.5, \
     "" using "angle":"by_1_theta" every 30 with points linetype 2 pointsize 0.5, \
     "" using "angle":"theta" with lines linetype 3, \
     "" using "angle":"eta" with lines linetype 1
