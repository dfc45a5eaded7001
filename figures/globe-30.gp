load "figures/style.gp"
set xlabel "amplitude (degrees)"
set ylabel "swing over that of a small one"
set xrange [0:170]
set xtics 30
stats tsv("globe-30.longer") using "amplitude":"rolling" nooutput
set yrange [1:STATS_max_y]
set rmargin 12
plot tsv("globe-30.smooth") using "amplitude":"smooth" with lines linetype 6 linewidth 1.4, \
     tsv("globe-30.longer") using "amplitude":"first" with lines linetype 7 dashtype 2, \
     "" using "amplitude":"second" with lines linetype 7 dashtype 3, \
     "" using "amplitude":"rolling" with lines linetype 1, \
     "" using "amplitude":"rolling":("rolling") every ::68::68 with labels right offset -1, 0.4 textcolor linetype 1, \
     "" using (170):"first":("one") every ::84::84 with labels left offset 0.4, 0 textcolor linetype 7, \
     "" using (170):"second":("two") every ::84::84 with labels left offset 0.4, 0 textcolor linetype 7, \
     tsv("globe-30.smooth") using "amplitude":"smooth":("smooth plane") every ::75::75 with labels left offset 1.4, 0 textcolor linetype 6
