short = 1
load "figures/style.gp"
set xrange [-1.2:1.2]
set yrange [4.6:0.4]
set lmargin 16
set border 1
set ytics ("l 1,00001904" 1, "l 2,30258509" 2, "l 2,3601799" 3, "their sum" 4) scale 0
set xlabel "our copy less the truth (units of the seventh place)"
set object 1 rectangle from -0.5, 0.4 to 0.5, 4.6 fillcolor rgb blue fillstyle solid 0.12 noborder behind
set label "rounding" at -0.25, 2.05 center textcolor linetype 1
plot tsv("pendulum-35.off") using (0):"line":"off":(0) with vectors nohead linetype 2 linewidth 2, \
     "" using "off":"line" with points linetype 2 pointsize 0.8
