load "figures/style.gp"
curves = "globe-13.times"; marks = "globe-13.second"
stats tsv(curves) using "h" every ::200 nooutput; h0 = STATS_max
stats tsv(curves) using "quarter" every ::200 nooutput; t0 = STATS_min
stats tsv(curves) using "h_1" every ::200 nooutput; h1 = STATS_max
stats tsv(curves) using "quarter_1" every ::200 nooutput; t1 = STATS_min
stats tsv(curves) using "h_3" every ::200 nooutput; h3 = STATS_max
stats tsv(curves) using "quarter_3" every ::200 nooutput; t3 = STATS_min
set xlabel "energy {/:Italic h}"
set ylabel "time of a quarter, in {/:Italic k} : √2{/:Italic gc}"
right = h0 > 4 ? 4 : (h0 < 1.5 ? 1.5 : h0)
set xrange [0:right]
set yrange [0:12]
set label "{/:Italic c} = 3{/:Italic k}" at h3, t3 left offset 0.7, 0 textcolor linetype 4
set label "{/:Italic c} = {/:Italic k}" at h1, t1 left offset 0.7, 0.7 textcolor linetype 3
if (h0 > 2) set label "this ball" at right, t0 right offset 0, 2 textcolor linetype 1
if (h0 <= 2) set label "this ball" at h0, t0 left offset 0.7, 1 textcolor linetype 1
plot tsv(curves) using "h_3":"quarter_3" with lines linetype 4, \
     "" using "h_1":"quarter_1" with lines linetype 3, \
     "" using "h":"quarter" with lines linetype 1, \
     tsv(marks) using "h_3":"quarter_3" with points linetype 4 pointtype 7 pointsize 0.9, \
     "" using "h_1":"quarter_1" with points linetype 3 pointtype 7 pointsize 0.9, \
     "" using "h":"quarter" with points linetype 1 pointsize 0.9
