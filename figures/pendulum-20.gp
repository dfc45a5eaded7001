load "figures/style.gp"
set rmargin 12
set xrange [0:90]
set xtics 15 format "%g°"
set yrange [0:1]
set format y "%.1f"
set xlabel "α"
set ylabel "share of the integral"
set label "cos α/sin^8α" at 30, 0.78 left textcolor linetype 1
set label "cos α/sin^2α" at 91.5, 0.325 left textcolor linetype 5
set label "l cot ½α" at 91.5, 0.262 left textcolor linetype 7
set label "cos α/sin^4α" at 91.5, 0.2 left textcolor linetype 4
set label "cos α/sin^6α" at 91.5, 0.138 left textcolor linetype 3
f = tsv("pendulum-20.shares")
plot f using "alpha":"s8" with lines linetype 1, "" using "alpha":"s6" with lines linetype 3, \
     "" using "alpha":"s4" with lines linetype 4, "" using "alpha":"s2" with lines linetype 5, \
     "" using "alpha":"l" with lines linetype 7
