load "figures/style.gp"
curves = "globe-11.portrait"
stats tsv(curves) using "h_d" nooutput
high = 1.15 * STATS_max
left(angle, none) = angle < 0 && none > 0 && none < high ? angle : NaN
stats tsv(curves) using (left(column("Phi"), column("none"))) nooutput
edge = STATS_max
stats tsv(curves) using (column("h_b") > 0 ? column("Phi") : NaN) nooutput
foot = STATS_max
set xlabel "angle Φ (degrees)"
set ylabel "angular velocity, in the ζ of Case II"
set xrange [-180:180]
set yrange [0:high]
set xtics -180, 60, 180
set label "no pressure" at edge, graph 0.95 left offset 1, 0 textcolor linetype 6
drawn(value) = value > 0 && value < high ? value : NaN
# Outwards from the lowest place: down to the axis where the ball turns back, and no further.
out(angle, value) = (before = angle == 0 ? 0 : last, last = value, angle >= 0 && (value > 0 || before > 0) ? value : NaN)
last = 0
named(value) = sprintf("{/:Italic h} = %.3g", value ** 2)
plot for [side = -1:1:2] for [name in "h_a h_b h_c h_lift h_d"] tsv(curves) \
       using (side * column("Phi")):(out(column("Phi"), column(name))) with lines linetype 1, \
     tsv(curves) using "Phi":"top" with lines linetype 2, \
     "" using "Phi":(drawn(column("none"))) with lines linetype 6 dashtype (6, 4), \
     "" using "Phi":"h_a":(named(column("h_a"))) every ::180::180 with labels offset 0, -0.7 textcolor linetype 1, \
     "" using (-foot):(0):(named(column("h_b"))) every ::180::180 with labels right offset -0.9, 0.6 textcolor linetype 1, \
     for [name in "h_c h_lift h_d"] "" using "Phi":name:(named(column(name))) every ::180::180 \
       with labels offset 0, 0.6 textcolor linetype 1, \
     "" using "Phi":"top":(named(column("top"))) every ::180::180 with labels offset 0, 0.6 textcolor linetype 2
