load "figures/style.gp"
set xrange [0:90]
set xtics 15 format "%g°"
set yrange [0:1.05]
set xlabel "angle φ with the vertical"
set ylabel "r / a"
set label "cycloid" at 73, 0.34 left textcolor linetype 6
set label "to k²" at 71.5, 0.06 left textcolor linetype 5
set label "Euler, to k⁴" at 63.5, 0.12 right textcolor linetype 2
set label "exact, the highest" at 50.5, 0.5 right textcolor linetype 1
plot tsv("tautochrone-30.radius") using "phi":"cycloid" with lines linetype 6, \
     "" using "phi":(column("kk") > 0 ? column("kk") : NaN) with lines linetype 5, \
     "" using "phi":(column("k4") > 0 ? column("k4") : NaN) with lines linetype 2, \
     tsv("tautochrone-30.exact") using "phi":"exact" with lines linetype 1, \
     "" using "phi":"exact" every ::140::140 with points linetype 1
