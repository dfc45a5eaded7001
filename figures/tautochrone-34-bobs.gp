tall = 1
load "figures/style.gp"
set size ratio -1
unset border; unset tics; unset grid
bobs = tsv("tautochrone-34.bobs")
arcs = tsv("tautochrone-34.arcs")
stats bobs using (column("y")) every ::0::0 name "HY" nooutput
stats bobs using (column("down")) every ::0::0 name "HX" nooutput
stats bobs using (column("y")) every ::1::1 name "EY" nooutput
stats bobs using (column("down")) every ::1::1 name "EX" nooutput
stats bobs using (column("y")) every ::2::2 name "XY" nooutput
stats bobs using (column("down")) every ::2::2 name "XX" nooutput
set xrange [-0.66:0.66]
set yrange [-1.12:0.06]
set label "{/:Italic A}" at 0, 0.035 center textcolor linetype 7
set label "Huygens’s" at HY_max, -HX_max - 0.065 center textcolor linetype 3
set label "Euler’s" at EY_max + 0.02, -EX_max - 0.075 center textcolor linetype 2
set label "exact" at XY_max + 0.055, -XX_max left textcolor linetype 1
plot arcs using (column("kind") == 2 ? column("y") : NaN):(-column("down")) with lines linetype 6, \
     arcs using (column("kind") == 0 ? column("q") : NaN):(-column("p")) with lines linetype 3, \
     arcs using (column("kind") == 1 ? column("q") : NaN):(-column("p")) with lines linetype 2, \
     arcs using (column("kind") == 2 ? column("q") : NaN):(-column("p")) with lines linetype 1, \
     bobs every ::0::0 using "q":(-column("p")):(column("y") - column("q")):(column("p") - column("down")) \
       with vectors nohead linetype 3, \
     bobs every ::1::1 using "q":(-column("p")):(column("y") - column("q")):(column("p") - column("down")) \
       with vectors nohead linetype 2, \
     bobs every ::2::2 using "q":(-column("p")):(column("y") - column("q")):(column("p") - column("down")) \
       with vectors nohead linetype 1, \
     bobs every ::0::0 using "y":(-column("down")) with points linetype 3 pointtype 7 pointsize 2.2, \
     bobs every ::1::1 using "y":(-column("down")) with points linetype 2 pointtype 7 pointsize 2.2, \
     bobs every ::2::2 using "y":(-column("down")) with points linetype 1 pointtype 7 pointsize 2.2
