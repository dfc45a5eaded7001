load "figures/style.gp"
file = tsv("balance-15.tongues")
set xrange [0:0.4]
set yrange [0.2:2.6]
set xlabel "{/:Italic p} = {/:Italic am} / {/:Italic b}"
set ylabel "λ / μ" offset 0, 0
set lmargin 10
set label "swings grow" at 0.22, 2.1 center textcolor linetype 2
set label "bounded" at 0.22, 1.3 center textcolor linetype 1
set label "Euler’s example" at 0.09, 1. / 3 left textcolor linetype 1
do for [k = 1:3] { set label sprintf("%d", k) at 0.005, 2. / k + 0.09 left textcolor linetype 6 }
bounds(n) = sprintf("from%d", n)
ends(n) = sprintf("to%d", n)
plot for [n = 1:3] file using "p":(column(bounds(n))):(column(ends(n))) with filledcurves linetype 2 \
       fillstyle transparent solid 0.18, \
     for [n = 1:3] file using "p":(column(bounds(n))) with lines linetype 2, \
     for [n = 1:3] file using "p":(column(ends(n))) with lines linetype 2, \
     "+" using (1. / 12):(1. / 3) every ::0::0 with points linetype 1 pointsize 0.9
