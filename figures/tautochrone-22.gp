load "figures/style.gp"
set xrange [0:0.75]
set yrange [0.99:1.07]
set xlabel "√({/:Italic x} / {/:Italic a})"
set ylabel "σ / √(2{/:Italic fx})"
set label "circle" at 0.5, 1.03 right textcolor linetype 6
set label "Huygens’s cycloid" at 0.6, 1.012 left textcolor linetype 3
set label "tautochrone" at 0.1, 0.996 left textcolor linetype 1
set arrow from 0, 1 to 0.7, 1 nohead linetype 1
plot tsv("tautochrone-22.straight") using "root_x":"circle" with lines linetype 6, \
     "" using "root_x":"cycloid" with lines linetype 3
