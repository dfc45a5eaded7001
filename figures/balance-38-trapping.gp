load "figures/style.gp"
set xlabel "P's first swing, {/:Italic n} : {/:Italic n_c}"
set ylabel "Q's farthest swing, in parts of P's first"
set xrange [0.4:2]
set yrange [0:1.1]
set arrow from 1, 0 to 1, 1.1 nohead linetype 6 dashtype (6, 4)
plot tsv("balance-38.reach") using "r":"Q" with lines linetype 1, \
     tsv("balance-38.reached") using "r":"Q" with points linetype 7
