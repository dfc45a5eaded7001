load "figures/style.gp"
set xrange [0:1]
set yrange [0:6]
set xlabel "v"
set ylabel "(V − ¼) / v"
set label "area ¾ {/:Italic l} 2" at 0.98, 0.28 right textcolor linetype 1
f = tsv("pendulum-24.integrand")
plot f using "v":"integrand" with filledcurves y=0 linecolor rgb blue, "" using "v":"integrand" with lines linetype 1
