load "figures/style.gp"
set logscale xy
set xrange [0.01:0.5]
set yrange [1e-16:1]
set ytics 1e-16, 1e4
set format y "10^{%T}"
set xtics (0.01, 0.02, 0.05, 0.1, 0.2, 0.5)
set xlabel "{/:Italic k} / {/:Italic a}"
set ylabel "what the equation leaves, over {/:Italic a}^5"
set label "cycloid" at 0.0115, 8e-4 left textcolor linetype 6
set label "with {/:Italic P}" at 0.0115, 9e-7 left textcolor linetype 5
set label "{/:Italic P} and {/:Italic Q}, Euler" at 0.0115, 2e-9 left textcolor linetype 2
set label "three" at 0.024, 1e-13 left textcolor linetype 3
plot tsv("tautochrone-28.left_sides") using "ratio":"n0" with lines linetype 6, \
     "" using "ratio":"n1" with lines linetype 5, \
     "" using "ratio":"n2" with lines linetype 2, \
     "" using "ratio":"n3" with lines linetype 3
