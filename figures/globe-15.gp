load "figures/style.gp"
curves = "globe-15.longer"
do for [name in "ratio equal pendulum"] {
  stats tsv(curves) using (column("Phi") == 176 ? column(name) : NaN) nooutput
  eval name . "_end = STATS_max"
}
set xlabel "amplitude Φ (degrees)"
set ylabel "{/:Italic T} : {/:Italic T}_0"
set xrange [0:176]
set yrange [1:1.03 * (ratio_end > equal_end ? ratio_end : equal_end)]
set xtics 0, 30, 150
set rmargin 10
set label "{/:Italic c} = {/:Italic k}" at 176, equal_end left offset 0.5, 0.4 textcolor linetype 3
set label "this ball" at 176, ratio_end left offset 0.5, 0.4 textcolor linetype 1
set label "pendulum" at 176, pendulum_end left offset 0.5, -0.6 textcolor linetype 6
plot tsv(curves) using "Phi":"equal" with lines linetype 3, \
     "" using "Phi":"ratio" with lines linetype 1, \
     "" using "Phi":"pendulum" with lines linetype 6
