load "figures/style.gp"
set size ratio -1
set xtics 0.05 format "%.2f"
set ytics 0.05 format "%.2f"
set lmargin 10
set xlabel "{/:Italic y} / {/:Italic a}"
set ylabel "{/:Italic x} / {/:Italic a}" offset 0, 0
file = tsv("tautochrone-32.curves")
of(n) = column("kind") == n ? column("x") : NaN
# the upper parts: a window about the ends of Euler's curve and of the exact one
stats file index 2 every ::60::60 using "y" name "Ey" nooutput
stats file index 2 every ::60::60 using "x" name "Ex" nooutput
stats file index 3 every ::59::59 using "y" name "Ty" nooutput
stats file index 3 every ::59::59 using "x" name "Tx" nooutput
set xrange [0.88 * Ey_min : 1.1 * (Ey_min > Ty_min ? Ey_min : Ty_min)]
set yrange [0.74 * Ex_min : 1.06 * (Ex_min > Tx_min ? Ex_min : Tx_min)]
plot file using "y":(of(0)) with lines linetype 6, \
     file using "y":(of(1)) with lines linetype 3, \
     file using "y":(of(3)) with lines linetype 1, \
     file using "y":(of(2)) with lines linetype 2, \
     file index 2 every ::60::60 using "y":"x" with points linetype 2, \
     file index 3 every ::59::59 using "y":"x" with points linetype 1, \
     file index 2 every ::60::60 using "y":"x":("Euler") with labels left offset 0.6, 0.9 textcolor linetype 2, \
     file index 3 every ::59::59 using "y":"x":("exact") with labels right offset -0.8, 0.3 textcolor linetype 1, \
     file index 0 every ::43::43 using "y":"x":("circle") with labels left offset 0.8, -0.7 textcolor linetype 6, \
     file index 1 every ::31::31 using "y":"x":("cycloid") with labels right offset -1.6, 0 textcolor linetype 3
