load "figures/style.gp"
curves = "globe-20.limit"; mark = "globe-20.here"
stats tsv(mark) using "ratio" nooutput; x = STATS_max
stats tsv(mark) using "n" nooutput; y = STATS_max
set xlabel "shape {/:Italic c} : {/:Italic k}"
set ylabel "{/:Italic n}"
set logscale xy
set format x "%g"
left = x < 0.01 ? x / 2 : 0.01
right = x > 10 ? 2 * x : 10
low = y < 1 ? y / 2 : 0.5
high = y > 100 ? 2 * y : 100
set xrange [left:right]
set yrange [low:high]
set label "leaves the plane" at 0.9, 12 center textcolor linetype 2
set label "turns over on the plane" at 0.0115, 4 left textcolor linetype 1
set label "rocks" at 0.3, 0.85 center textcolor linetype 7
set label "√2" at right, sqrt(2) right offset -0.5, -0.9 textcolor linetype 6
set label "this ball" at x, y left offset 0.8, 0 textcolor linetype 7
plot tsv(curves) using "ratio":(sqrt(2)):"n" with filledcurves linecolor rgb blue, \
     sqrt(2) with lines linetype 6, \
     tsv(curves) using "ratio":"n" with lines linetype 2, \
     tsv(mark) using "ratio":"n" with points linetype 7 pointsize 1
