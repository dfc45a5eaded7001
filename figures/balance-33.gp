load "figures/style.gp"
set xrange [0:2 * pi]
set xlabel "{/:Italic t} (seconds)"
set ylabel "formula less true η (degrees)"
set key top left reverse Left
plot tsv("balance-33.missed") using "t":"euler" with lines linetype 2 title "by (2)", \
     "" using "t":"corrected" with lines linetype 3 title "amplitudes corrected", \
     "" using "t":"second" with lines linetype 6 dashtype (6, 4) title "second order"
