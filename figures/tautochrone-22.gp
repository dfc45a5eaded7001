load "figures/style.gp"
set xrange [0:0.75]
set yrange [0.99:1.07]
set xlabel "√({/:Italic x} / {/:Italic a})"
set ylabel "σ / √(2{/:Italic fx})"
set label "tautochrone" at 0.1, 0.996 left textcolor linetype 1
set arrow from 0, 1 to 0.7, 1 nohead linetype 1
plot tsv("tautochrone-22.straight") using "root_x":"circle" with lines linetype 6, \
     "" using "root_x":"cycloid" with lines linetype 3, \
     "" every ::70::70 using "root_x":"circle":("circle") with labels right offset -0.8, 0.5 textcolor linetype 6, \
     "" every ::92::92 using "root_x":"cycloid":("Huygens’s\ncycloid") with labels left offset 0.2, -1.8 textcolor linetype 3
