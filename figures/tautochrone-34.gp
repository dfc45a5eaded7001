tall = 1
load "figures/style.gp"
set size ratio -1
set xrange [0:0.85]
set yrange [-0.62:0.04]
set lmargin 9
set xlabel "{/:Italic q} / {/:Italic a}"
set ylabel "−{/:Italic p} / {/:Italic a}" offset -1, 0
set label "{/:Italic k} = 0" at 0.6, -0.44 left textcolor linetype 6
set label "0.1 {/:Italic a}" at 0.52, -0.55 right textcolor linetype 2
set label "0.3 {/:Italic a}" at 0.29, -0.53 right textcolor linetype 2
set label "exact" at 0.15, -0.42 right textcolor linetype 1
file = tsv("tautochrone-34.cheeks")
plot file using "q":(column("ratio") == 0 ? -column("p") : NaN) with lines linetype 6, \
     file using "q":(column("ratio") == 0.1 ? -column("p") : NaN) with lines linetype 2, \
     file using "q":(column("ratio") == 0.3 ? -column("p") : NaN) with lines linetype 2, \
     tsv("tautochrone-34.exact") using "q":(-column("p")) with lines linetype 1 dashtype (6, 4)
