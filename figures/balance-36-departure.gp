load "figures/style.gp"
set xrange [0:360]
set xtics 60 format "%g°"
set mxtics 2
set yrange [-27:27]
set format y "%g′"
set xlabel "time as an angle, λt"
set ylabel "minutes of η"
set rmargin 3
set label "truth less Euler's formula" at 131, 23 textcolor linetype 1
set label "what the formula adds\nto a regular swing" at 6, -12 textcolor linetype 2
set label "left when both\nsteps are made" at 352, 9 right textcolor linetype 6
plot tsv("balance-36.motion") using "angle":"from_lengthened" with lines linetype 6, \
     "" using "angle":"strays" with lines linetype 2, \
     "" using "angle":"from_euler" with lines linetype 1
