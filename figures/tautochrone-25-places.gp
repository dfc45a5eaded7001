load "figures/style.gp"
set logscale y
set xrange [4:104]
set yrange [1e-17:10]
set format y "10^{%T}"
set ytics 1e-16, 1e4
set xtics 20
set xlabel "places"
set ylabel "error of {/:Italic r} / {/:Italic a}"
set label "without" at 84, 5e-10 left textcolor linetype 2
set label "told the outer value" at 60, 5e-15 left textcolor linetype 1
plot tsv("tautochrone-25.places") using "n":"untold" with linespoints linetype 2, \
     "" using "n":"told" with linespoints linetype 1
