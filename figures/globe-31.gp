load "figures/style.gp"
set logscale xy
set xlabel "{/:Italic c} over {/:Italic a}"
set ylabel "length of the pendulum over {/:Italic a}"
set xrange [0.1:10]
plot tsv("globe-31.both") using "c":"smooth" with lines linetype 6 linewidth 1.4, \
     "" using "c":"rolling" with lines linetype 1, \
     "" using "c":"smooth":("smooth plane") every ::24::24 with labels right offset -1, -0.4 textcolor linetype 6, \
     "" using "c":"rolling":("rolling") every ::14::14 with labels left offset 1, 0.6 textcolor linetype 1, \
     tsv("globe-31.marks") using "c":"l" with points linetype 7 pointsize 0.8
