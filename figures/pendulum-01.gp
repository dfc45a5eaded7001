load "figures/style.gp"
file = tsv("pendulum-01.corrections")
stats file using "body" name "B" nooutput
stats file using "arc" name "A" nooutput
most = 1.08 * (A_max > B_max ? A_max : B_max)
least = B_min < 0 ? 1.1 * B_min : 0
high = most - least
set xrange [0:120]
set yrange [least:most]
set xtics 20 format "%g°"
set format y "%g %%"
set xlabel "amplitude ζ"
set lmargin 9
set ylabel "correction" offset 0, 0
stats file using "zeta":(column("zeta") <= 96 ? column("arc") : NaN) name "L" nooutput
body = "for the body, √(b/a) − 1"
if (B_max < 0.25 * most) { set label body at 118, B_max + 0.05 * high right textcolor linetype 3 } \
else { set label body at 4, B_max + 0.05 * high left textcolor linetype 3 }
set label "for the arc, T/Θ − 1" at 94, L_max_y + 0.03 * high right textcolor linetype 1
plot file using "zeta":"body" with lines linetype 3, "" using "zeta":"arc" with lines linetype 1
