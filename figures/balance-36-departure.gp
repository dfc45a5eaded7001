load "figures/style.gp"
set xrange [0:360]
set xtics 60 format "%g°"
set mxtics 2
set yrange [-27:27]
set format y "%g′"
set xlabel "time as an angle, λt"
set ylabel "minutes of η"
set rmargin 11
set label "truth less Euler's formula" at 243, 22.5 right textcolor linetype 1
set label "what the formula adds\nto a regular swing" at 6, -12 textcolor linetype 2
set label "after both\nsteps" at 364, 4 textcolor linetype 6
plot tsv("balance-36.motion") using "angle":"from_lengthened" with lines linetype 6, \
     "" using "angle":"strays" with lines linetype 2, \
     "" using "angle":"from_euler" with lines linetype 1
