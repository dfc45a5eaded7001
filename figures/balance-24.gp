load "figures/style.gp"
set xlabel "the beam's swing (degrees)"
set lmargin 9
set ylabel offset 0, 0 "mean frequency : λ, less 1 (per cent)"
set xrange [0:15.5]
set rmargin 12
file = tsv("balance-24.slower")
stats file using "pendulum" every ::14::14 name "P" nooutput
stats file using "theory" every ::14::14 name "A" nooutput
set label "pendulum" at graph 1.01, first P_min left textcolor linetype 2
set label "with pans" at graph 1.01, first A_min left textcolor linetype 1
plot file using "m":"pendulum" with lines linetype 2, file using "m":"theory" with lines linetype 1, \
     file using "m":"full" with points linetype 7
