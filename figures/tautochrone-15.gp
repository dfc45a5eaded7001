load "figures/style.gp"
set lmargin 10
set xrange [0:90]
set yrange [0:1.14]
set xtics 20 format "%g°"
set ytics 0.2 format "%.1f"
set xlabel "angle φ"
set ylabel "{/:Italic GZ} : {/:Italic GH}"
set object 1 rectangle from 0, 1 to 90, 1.14 fillcolor rgb vermilion fillstyle transparent solid 0.12 noborder behind
set label "where Euler’s words put it" at 45, 1.07 center textcolor linetype 2
file = tsv("tautochrone-15.ratios")
of(n) = column("amplitude") == n ? column("ratio") : NaN
do for [n in "20 40 60 80"] { set label "to ".n."°" at n + 1.2, 0.955 left textcolor linetype 1 }
plot 1 with lines linetype 6, \
     file using "phi":(of(20)) with lines linetype 1, \
     file using "phi":(of(40)) with lines linetype 1, \
     file using "phi":(of(60)) with lines linetype 1, \
     file using "phi":(of(80)) with lines linetype 1
