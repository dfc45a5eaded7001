load "figures/style.gp"
set logscale xy
set xrange [0.01:0.5]
set yrange [1e-16:1]
set ytics 1e-16, 1e4
set format y "10^{%T}"
set xtics (0.01, 0.02, 0.05, 0.1, 0.2, 0.5)
set xlabel "{/:Italic k} / {/:Italic a}"
set ylabel "what the equation leaves, over {/:Italic a}^5"
plot tsv("tautochrone-28.left_sides") using "ratio":"n0" with lines linetype 6, \
     "" using "ratio":"n1" with lines linetype 5, \
     "" using "ratio":"n2" with lines linetype 2, \
     "" using "ratio":"n3" with lines linetype 3, \
     "" every ::8::8 using "ratio":"n0":("cycloid") with labels left offset 0, 1.2 textcolor linetype 6, \
     "" every ::8::8 using "ratio":"n1":("with {/:Italic P}") with labels left offset -1.5, 1.3 textcolor linetype 5, \
     "" every ::9::9 using "ratio":"n2":("Euler") with labels right offset -0.5, 0.5 textcolor linetype 2, \
     "" every ::12::12 using "ratio":"n3":("three") with labels left offset 0.8, -0.7 textcolor linetype 3
