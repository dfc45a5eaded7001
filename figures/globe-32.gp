load "figures/style.gp"
file = tsv("globe-32.decay")
set logscale xy
set xrange [0.9:20]
set xtics (1, 2, 4, 8, 16)
set xlabel "swings {/:Italic n}"
set ylabel "excess over the threshold (degrees)" offset -0.5, 0
set lmargin 9
plot file using "n":"law" with lines linetype 6 linewidth 1.4, \
     file using "n":"excess" with points linetype 1 pointsize 0.8, \
     "" using "n":"excess":("followed") every ::1::1 with labels left offset 1, 0.4 textcolor linetype 1, \
     "" using "n":"law":("1 : {/:Italic Kn}") every ::1::1 with labels right offset -0.6, -0.8 textcolor linetype 6
