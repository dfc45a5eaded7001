load "figures/style.gp"
file = tsv("globe-33.orders")
set logscale xy
set format y "10^{%T}"
set xlabel "{/:Italic c} over {/:Italic a}"
set ylabel "error, as a part of the time" offset -1.2, 0
set lmargin 11
plot file using "c":"rule" with lines linetype 2, \
     file using "c":"right" with lines linetype 1, \
     "" using "c":"rule":("the rule") every ::30::30 with labels right offset -1, 0.7 textcolor linetype 2, \
     "" using "c":"right":("put right") every ::30::30 with labels left offset 1, -0.7 textcolor linetype 1
