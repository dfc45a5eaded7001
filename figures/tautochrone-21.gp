load "figures/style.gp"
set logscale x
set xrange [1e-4:0.9]
set yrange [0:10]
set format x "10^{%T}"
set xlabel "height of the rise, over {/:Italic a}"
set ylabel "time of a swing"
set label "{/:Italic p} = 0.4" at 9e-4, 9.5 left textcolor linetype 6
set label "½, the cycloid" at 2e-3, 4.9 left textcolor linetype 1
set label "0.6" at 4e-4, 2.6 left textcolor linetype 6
set label "1" at 4e-3, 0.75 left textcolor linetype 6
plot tsv("tautochrone-21.powers") using "c":"p40" with lines linetype 6, \
     "" using "c":"p60" with lines linetype 6, \
     "" using "c":"p100" with lines linetype 6, \
     "" using "c":"p50" with lines linetype 1
