load "figures/style.gp"
set xrange [-180:180]
set yrange [-1.5:1.5]
set xtics 45 format "%g°"
set ytics 0.5
set xlabel "angle Φ"
set ylabel "moment / Ma"
set label "gravity, sin Φ" at 106, 1.17 left textcolor linetype 1
set label "small swings, Φ" at 62, 1.3 right textcolor linetype 6
set label "top" at 176, -0.16 right
set label "top" at -176, 0.14 left
plot tsv("pendulum-04.moments") using "phi":(abs(column("small")) < 1.5 ? column("small") : NaN) with lines linetype 6 dashtype (4, 4), \
     "" using "phi":"moment" with lines linetype 1
