load "figures/style.gp"
curves = "globe-23.turning"; border_of = "globe-23.edge"
stats tsv(curves) using "own" nooutput; own = STATS_max; own_low = STATS_min
stats tsv(curves) using "over" nooutput; high = STATS_max; over_low = STATS_min
stats tsv(curves) using "limit" nooutput; limit = STATS_max; limit_low = STATS_min
stats tsv(border_of) using "w" nooutput; corner = STATS_min
top = 1.15 * (own > high ? own : high)
set xlabel "angle Φ (degrees)"
set ylabel "dΦ/d{/:Italic t}, in √2{/:Italic gc} : {/:Italic k}"
set xrange [0:180]
set xtics 0, 30, 180
low = 0.8 * (own_low < limit_low ? own_low : limit_low)
set yrange [low:top]
set label "the plane" at graph 0.98, graph 0.93 right textcolor linetype 6
set label "would have" at graph 0.98, graph 0.86 right textcolor linetype 6
set label "to pull" at graph 0.98, graph 0.79 right textcolor linetype 6
set label "this ball" at 4, own offset 0, -0.9 textcolor linetype 1
set label "as fast as it can" at 4, limit offset 0, 0.7 textcolor linetype 3
set label "faster" at 4, high offset 0, 0.7 textcolor linetype 2
plot tsv(border_of) using "Phi":"w":(top) with filledcurves linecolor rgb grey, \
     tsv(border_of) using "Phi":"w" with lines linetype 6, \
     tsv(curves) using "over_Phi":"over" with lines linetype 2, \
     tsv(curves) using "limit_Phi":"limit" with lines linetype 3, \
     tsv(curves) using "own_Phi":"own" with lines linetype 1
