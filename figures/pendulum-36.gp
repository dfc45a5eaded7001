load "figures/style.gp"
set logscale x
set xrange [60:0.1]
set yrange [0:10]
set ytics 2
set xtics (60, 20, 10, 5, 2, 1, 0.5, 0.2, 0.1) format "%g°"
set xlabel "angle from the top, η"
set ylabel "T / Θ"
set label "exact" at 0.2, 4.4 center textcolor linetype 1
set label "Euler's rule" at 0.32, 8.5 right textcolor linetype 2
his(x) = sprintf("%.0f,%05.0f", floor(x), (x - floor(x)) * 1e5)  # with his comma
plot tsv("pendulum-36.swings") using "eta":"exact" with lines linetype 1, \
     "" using "eta":"euler" with lines linetype 2, \
     tsv("pendulum-36.examples") using "eta":"exact" with points linetype 1 pointsize 1, \
     "" using "eta":"euler" with points linetype 2 pointsize 1, \
     "" using "eta":"exact":(sprintf("%.5f", column("exact"))) with labels offset 0.8, -0.6 left textcolor linetype 1, \
     "" using "eta":"euler":(his(column("euler"))) with labels offset -1, 0.7 right textcolor linetype 2
