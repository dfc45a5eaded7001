tall = 1
load "figures/style.gp"
set xrange [0:360]
set xtics 60 format "%g°"
set mxtics 2
set yrange [-11.5:12.5]
set ytics 5 format "%g°"
set xlabel "time as an angle, λt"
set ylabel "inclination (Euler's degrees)"
set rmargin 3
set label "beam ω" at 38, 9.3 textcolor linetype 4
set label "pan P, η" at 120, 11.3 center textcolor linetype 1
set label "pan Q, ϑ" at 256, 8.9 textcolor linetype 3
set label "Euler's table" at 216, -9.6 textcolor linetype 2
plot tsv("balance-36.motion") using "angle":"omega" with lines linetype 4, \
     "" using "angle":"theta" with lines linetype 3, \
     "" using "angle":"eta" with lines linetype 1, \
     "" every 30 using "angle":"euler_omega" with points linetype 2 pointsize 0.35, \
     "" every 30 using "angle":"euler_eta" with points linetype 2 pointsize 0.35, \
     "" every 30 using "angle":"euler_theta" with points linetype 2 pointsize 0.35
