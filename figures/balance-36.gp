load "figures/style.gp"
strays = tsv("balance-36.strays")
most = 0
inner(x) = x < 15 ? 15 : x > 345 ? 345 : x
do for [name in "by_1_eta theta eta"] {
  stats strays using "angle":name nooutput
  if (STATS_max_y > most) { most = STATS_max_y }
  if (-STATS_min_y > most) { most = -STATS_min_y }
  if (name eq "theta") { set label "Q" at inner(STATS_pos_min_y), STATS_min_y - 0.08 * most center textcolor linetype 3 }
}
set label "P" at inner(STATS_pos_max_y), STATS_max_y + 0.08 * most center textcolor linetype 1
stats strays using "angle":"by_1_theta" every ::::150 nooutput
set label "by (1)" at inner(STATS_pos_max_y - 20), STATS_max_y + 0.08 * most center textcolor linetype 2
set xrange [0:360]
set xtics 60 format "%g°"
set mxtics 2
set yrange [-1.2 * most:1.2 * most]
set lmargin 9
set format y "%g′"
set xlabel "time as an angle, λt"
set ylabel "strays from a regular swing" offset 0, 0
plot strays using "angle":"by_1_eta" with lines linetype 2 linewidth 0.8, \
     "" using "angle":"by_1_theta" with lines linetype 2 linewidth 0.8, \
     "" using "angle":"by_1_eta" every 30 with points linetype 2 pointsize 0.5, \
     "" using "angle":"by_1_theta" every 30 with points linetype 2 pointsize 0.5, \
     "" using "angle":"theta" with lines linetype 3, \
     "" using "angle":"eta" with lines linetype 1
