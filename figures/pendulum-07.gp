load "figures/style.gp"
set xrange [0:1]
set yrange [0:6]
set xlabel "part of the way to the turning point"
set ylabel "time per part of the way"
set label "measured by Φ" at 0.83, 3.4 right textcolor linetype 1
set label "measured by θ" at 0.06, 1.85 left textcolor linetype 3
plot tsv("pendulum-07.elements") using "part":(column("in_phi") < 6 ? column("in_phi") : NaN) with lines linetype 1, \
     "" using "part":"in_theta" with lines linetype 3
