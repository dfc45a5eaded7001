load "figures/style.gp"
file = tsv("globe-08.cradle")
set xlabel "time, 2{/:Italic g} being 1"
set lmargin 9
set ylabel "angle Φ (degrees)" offset -0.3, 0
set xzeroaxis linetype 6
set label "scrapes" at 1.2, 40 left textcolor linetype 2
set label "rolls" at 8.9, -8 left textcolor linetype 1
plot file using "t":"Phi_deg":(column("mode") == 2 ? 1 : 2) with lines linecolor variable linewidth 1.6
