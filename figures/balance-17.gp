load "figures/style.gp"
set xrange [0:4]
set yrange [-6:6]
set xlabel "λ / μ"
set ylabel "strength, in 𝔄ℭ{/:Italic a} / {/:Italic b}"
set arrow from 2, -6 to 2, 6 nohead linetype 6
set arrow from 0, 0 to 4, 0 nohead linetype 6
set label "{/:Italic M}, at μ − λ" at 1.35, 3 right textcolor linetype 1
set label "{/:Italic N}, at μ + λ" at 3.4, 1.25 center textcolor linetype 3
plot tsv("balance-17.tones") using "ratio":(column("ratio") < 2 ? column("M") : 1/0) with lines linetype 1, \
     "" using "ratio":(column("ratio") > 2 ? column("M") : 1/0) with lines linetype 1, \
     "" using "ratio":"N" with lines linetype 3
