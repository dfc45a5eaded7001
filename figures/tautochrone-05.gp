load "figures/style.gp"
file = tsv("tautochrone-05.widths")
set xrange [0:40]
set yrange [-0.7:3.4]
set rmargin 10
set xtics 10 format "%g°"
set ytics 1 format "%g %%"
set xlabel "amplitude φ_0"
set ylabel "{/:Italic T}/{/:Italic T}_0 − 1"
array Y[6]
do for [i = 1:6] {
  stats file using i + 1 every ::39 nooutput
  Y[i] = STATS_min
}
set label "β = 0" at 40.6, Y[1] left textcolor linetype 2
set label "β = 1/4" at 40.6, Y[2] left textcolor linetype 7
set label "β = 1/2" at 40.6, Y[3] left textcolor linetype 4
set label "β by (D)" at 40.6, Y[4] - 0.03 left textcolor linetype 3
set label "β = 1" at 40.6, Y[5] - 0.08 left textcolor linetype 6
set label "γ besides" at 40.6, Y[6] + 0.06 left textcolor linetype 1
plot file using "phi0":"b0" with lines linetype 2, "" using "phi0":"b25" with lines linetype 7, \
     "" using "phi0":"b50" with lines linetype 4, "" using "phi0":"best" with lines linetype 3, \
     "" using "phi0":"b100" with lines linetype 6, "" using "phi0":"both" with lines linetype 1
