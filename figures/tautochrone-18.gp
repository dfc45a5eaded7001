load "figures/style.gp"
set xrange [0:1]
set yrange [0:1.05]
set xtics 0.2 format "%.1f"
set ytics 0.2 format "%.1f"
set lmargin 10
set xlabel "height of {/:Italic G}, {/:Italic x} / {/:Italic c}"
set ylabel "{/:Italic v} / {/:Italic c}"
file = tsv("tautochrone-18.speeds")
plot file using "x":"k0" with lines linetype 7, \
     file using "x":"axis" with lines linetype 6, \
     file using "x":"k1" with lines linetype 1, \
     file using "x":"k3" with lines linetype 3, \
     file using "x":"k6" with lines linetype 2, \
     file every ::44::44 using "x":"k0":("{/:Italic k} = 0") with labels left offset 0.8, 0.4 textcolor linetype 7, \
     file every ::20::20 using "x":"k1":("{/:Italic a}/10") with labels left offset 1.2, 0.9 textcolor linetype 1, \
     file every ::16::16 using "x":"k3":("3{/:Italic a}/10") with labels center offset 0.3, -1.1 textcolor linetype 3, \
     file every ::34::34 using "x":"k6":("6{/:Italic a}/10") with labels right offset -0.6, -0.6 textcolor linetype 2, \
     file every ::62::62 using "x":"axis":("fixed axis, 6{/:Italic a}/10") with labels left offset 1.5, 1.2 textcolor linetype 6
