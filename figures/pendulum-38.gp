load "figures/style.gp"
set xrange [1:-300]
set yrange [0:4.2]
set xtics ("1" 0, "10^{-100}" -100, "10^{-200}" -200, "10^{-300}" -300)
set xlabel "η, radians"
set ylabel "error, ulp"
set rmargin 17
set label "mean" at -306, 1.9 textcolor linetype 4
set label "columns" at -306, 1.5 textcolor linetype 1
set label "one logarithm" at -306, 1.1 textcolor linetype 3
set label "theta function" at -306, 0.7 textcolor linetype 5
set label "this edition" at -306, 0.3 textcolor linetype 2
plot tsv("pendulum-38.agreement") using "power":"mean" with points linetype 4 pointsize 0.35, \
     "" using "power":"theta" with points linetype 5 pointsize 0.35, \
     "" using "power":"logarithm" with points linetype 3 pointsize 0.3, \
     "" using "power":"columns" with points linetype 1 pointsize 0.3, \
     "" using "power":"edition" with points linetype 2 pointsize 0.35
