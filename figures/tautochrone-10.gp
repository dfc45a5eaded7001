tall = 1
load "figures/style.gp"
set size ratio -1
unset border; unset tics; unset grid
set xrange [-0.2:1.25]
set yrange [-1.2:0.08]
file = tsv("tautochrone-10.loci")
set label "{/:Italic A}" at 0, 0.05 center textcolor linetype 7
set label "{/:Italic C}" at -0.05, -1 center textcolor linetype 7
set label "{/:Italic D}" at -0.05, -1.09 center textcolor linetype 7
plot file every 15 using "q":(-column("p")):(column("H_y") - column("q")):(column("p") - column("H_x")) \
       with vectors nohead linetype 6, \
     file using "q":(-column("p")) with lines linetype 7, \
     file using "G_y":(-column("G_x")) with lines linetype 7, \
     file using "Z_y":(-column("Z_x")) with lines linetype 1, \
     file using "H_y":(-column("H_x")) with lines linetype 2, \
     file every 15 using "G_y":(-column("G_x")) with points linetype 7, \
     file every 15 using "Z_y":(-column("Z_x")) with points linetype 1, \
     file every 15 using "H_y":(-column("H_x")) with points linetype 2, \
     file every ::33::33 using "G_y":(-column("G_x")):("{/:Italic G}") with labels offset -1, 0.6 textcolor linetype 7, \
     file every ::22::22 using "Z_y":(-column("Z_x")):("{/:Italic Z}") with labels offset 0.3, -0.75 textcolor linetype 1, \
     file every ::30::30 using "H_y":(-column("H_x")):("{/:Italic H}") with labels offset 1.4, -0.8 textcolor linetype 2
