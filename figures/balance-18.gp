load "figures/style.gp"
set xrange [0:2]
set yrange [-10:10]
set xlabel "half turns of the beam, λ{/:Italic t}/π"
set ylabel "beside the regular swing, minutes"
set xzeroaxis linetype 6
file = tsv("balance-18.strays")
set label "{/:Italic P}" at 0.08, 5.4 center textcolor linetype 1
set label "{/:Italic Q}" at 0.25, 9.4 center textcolor linetype 3
plot file using "turn":"P" with lines linetype 1, "" using "turn":"Q" with lines linetype 3
