load "figures/style.gp"
stats tsv("tautochrone-30.radius") using "phi" name "E" nooutput
set xrange [0 : 1.06 * E_max]
set xtics 15 format "%g°"
set logscale y
set yrange [1e-10:10]
set format y "10^{%T}"
set xlabel "angle φ with the vertical"
set ylabel "error of {/:Italic r} / {/:Italic a}"

error(name) = abs(column(name) - column("exact"))
plot tsv("tautochrone-30.radius") using "phi":(error("n0")) with lines linetype 6, \
     "" using "phi":(error("n1")) with lines linetype 5, \
     "" using "phi":(error("n2")) with lines linetype 2, \
     "" using "phi":(error("n4")) with lines linetype 3, \
     "" using "phi":(error("n8")) with lines linetype 4, \
     "" every ::42::42 using "phi":(error("n0")):("cycloid") with labels center offset 0, 0.8 textcolor linetype 6, \
     "" every ::42::42 using "phi":(error("n1")):("{/:Italic n} = 1") with labels center offset -0.5, 0.9 textcolor linetype 5, \
     "" every ::24::24 using "phi":(error("n2")):("2, Euler") with labels left offset 0.4, -0.8 textcolor linetype 2, \
     "" every ::34::34 using "phi":(error("n4")):("4") with labels right offset -0.8, 0.5 textcolor linetype 3, \
     "" every ::52::52 using "phi":(error("n8")):("8") with labels right offset -0.8, 0.5 textcolor linetype 4
