load "figures/style.gp"
file = tsv("balance-02.slow")
stats file using "c":"tilt" nooutput
least = STATS_min_x; most = STATS_max_x; steepest = STATS_max_y
stats file using "c":"time" nooutput
longest = STATS_max_y
set logscale xy
set xrange [least:most]
set format x "10^{%L}"
set xlabel "depth {/:Italic c} of the centre of gravity (ft)"
set ylabel "degrees, seconds"
set lmargin 9
set label "tilt under the overweight, °" at least * 50, steepest * 0.65 left textcolor linetype 1
set label "one swing of the beam, s" at least * 1.3, longest * 0.17 left textcolor linetype 3
plot file using "c":"tilt" with lines linetype 1, "" using "c":"time" with lines linetype 3
