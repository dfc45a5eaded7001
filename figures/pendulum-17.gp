load "figures/style.gp"
set logscale x
set xrange [0.62:12]
set yrange [0:6]
set xtics (1, 1.5, 2, 3, 5, 10)
set xlabel "ω / α"
set ylabel "ω · d{/:Italic t}/dω"
set label "exact" at 1.09, 4.6 left textcolor linetype 1
set label "10 terms" at 0.955, 3.52 right textcolor linetype 2
set label "3 terms" at 0.955, 1.97 right textcolor linetype 2
set label "2 terms" at 0.955, 1.47 right textcolor linetype 2
set label "1 term" at 0.955, 0.97 right textcolor linetype 2
f = tsv("pendulum-17.integrand")
plot f using "omega":"terms1" with lines linetype 2, "" using "omega":"terms2" with lines linetype 2, \
     "" using "omega":"terms3" with lines linetype 2, "" using "omega":"terms10" with lines linetype 2, \
     "" using "omega":"exact" with lines linetype 1 linewidth 2.2
