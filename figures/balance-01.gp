load "figures/style.gp"
file = tsv("balance-01.scene_drawn")
stats file using "t":"P_hull" nooutput
last = STATS_max_x
n = STATS_max_y
gap = 1.35 * n
set xrange [0:last]
set yrange [-gap - 1.35 * n:gap + 1.35 * n]
set xlabel "time (s)"
set lmargin 9
set ytics (sprintf("%.3g°", n) gap + n, "0" gap, sprintf("−%.3g°", n) gap - n, \
           sprintf("%.3g°", n) -gap + n, "0" -gap, sprintf("−%.3g°", n) -gap - n)
set label "P" at last * 1.02, gap textcolor linetype 1
set label "Q" at last * 1.02, -gap textcolor linetype 3
set rmargin 5
plot file using "t":(column("P_hull") + gap) with lines linetype 6, \
     file using "t":(-column("P_hull") + gap) with lines linetype 6, \
     file using "t":(column("Q_hull") - gap) with lines linetype 6, \
     file using "t":(-column("Q_hull") - gap) with lines linetype 6, \
     file using "t":(column("P") + gap) with lines linetype 1 linewidth 1.1, \
     file using "t":(column("Q") - gap) with lines linetype 3 linewidth 1.1
