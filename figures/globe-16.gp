load "figures/style.gp"
curves = "globe-16.too_great"
do for [name in "this_ball half equal"] {
  stats tsv(curves) using (column("Phi") == 90 ? 100 * column(name) : NaN) nooutput
  eval name . "_high = STATS_max"
}
set xlabel "angle Φ (degrees)"
set lmargin 9
set ylabel "too great by (%)" offset 0, 0
set logscale y
set format y "10^{%L}"
low = 1e-3 * (this_ball_high < half_high ? this_ball_high : half_high)
set xrange [0:180]
set yrange [low:30 * equal_high]
set xtics 0, 30, 180
set label "{/:Italic c} = {/:Italic k}" at 90, equal_high center offset 0, 0.7 textcolor linetype 3
set label "{/:Italic c} = ½ {/:Italic k}" at 90, half_high center offset 0, 0.7 textcolor linetype 4
set label "this ball" at 90, this_ball_high center offset 0, -0.8 textcolor linetype 1
plot tsv(curves) using "Phi":(100 * column("equal")) with lines linetype 3, \
     "" using "Phi":(100 * column("half")) with lines linetype 4, \
     "" using "Phi":(100 * column("this_ball")) with lines linetype 1
