load "figures/style.gp"
set xrange [1.4:4.7]
set yrange [-1.4:2.2]
set xtics 1
set xlabel "frequency"
set ylabel "beside the regular swing, in 720ths"
set xzeroaxis linetype 6
file = tsv("balance-35.tones")
set label "by Euler" at 1.93, 1.2 right textcolor linetype 2
set label "complete" at 2.12, -1.15 left textcolor linetype 1
stats file using "eta" every ::0::0 name "L" nooutput
stats file using "eta" every ::3::3 name "F" nooutput
plot file every ::0::2 using (column("frequency") - 0.05):(720 * column("eta_by_him")) with impulses linetype 2 linewidth 8, \
     file every ::1::2 using (column("frequency") + 0.05):(720 * column("eta")) with impulses linetype 1 linewidth 8, \
     file every ::0::0 using (column("frequency") + 0.05):(720 * (L_max + F_max)) with impulses linetype 1 linewidth 8
