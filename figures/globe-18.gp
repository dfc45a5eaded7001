tall = 1
load "figures/style.gp"
unset border
unset tics
unset grid
set size ratio -1
set xrange [-1.45:1.25]
set yrange [-1.22:1.2]
set parametric
set trange [0:2 * pi]
set label "{/:Italic C}" at 0.06, 0 textcolor linetype 7
set label "180°, never" at 0.06, 1.1 left textcolor linetype 6
set label "Φ = 90°" at -0.93, 0.06 left textcolor linetype 6
seconds(t) = t == 0 ? "0 s" : t < 0.75 ? sprintf("%.1f s", t) : ""
plot cos(t), sin(t) with lines linetype 6, \
     tsv("globe-18.climb") using (0):(0):"x":"y" with vectors nohead linetype 6 linewidth 0.5, \
     "" using "x":"y" with points linetype 1 pointsize 0.5, \
     "" using (1.17 * column("x")):(1.12 * column("y")):(seconds(column("time"))) with labels textcolor linetype 1, \
     "+" using (0):(1) every ::0::0 with points linetype 6 pointsize 0.7, \
     "+" using (0):(0) every ::0::0 with points linetype 7 pointsize 0.35
