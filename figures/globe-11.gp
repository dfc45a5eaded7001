load "figures/style.gp"
curves = "globe-11.portrait"
stats tsv(curves) using "h_d" nooutput
high = 1.15 * STATS_max
left(angle, none) = angle < 0 && none > 0 && none < high ? angle : NaN
stats tsv(curves) using (left(column("Phi"), column("none"))) nooutput
edge = STATS_max
set xlabel "angle Φ (degrees)"
set ylabel "angular velocity, in the ζ of Case II"
set xrange [-180:180]
set yrange [0:high]
set xtics -180, 60, 180
set label "no pressure" at edge, graph 0.95 left offset 1, 0 textcolor linetype 6
drawn(value) = value > 0 ? value : NaN
plot for [name in "h_a h_b h_c h_lift h_d"] tsv(curves) using "Phi":(drawn(column(name))) with lines linetype 1, \
     tsv(curves) using "Phi":"top" with lines linetype 2, \
     "" using "Phi":(drawn(column("none"))) with lines linetype 6 dashtype (6, 4)
