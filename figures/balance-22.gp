load "figures/style.gp"
stats tsv("balance-22.balances") using "p" name "P" nooutput
stats tsv("balance-22.balances") using "ratio" name "R" nooutput
set xlabel "frequency of the beam, λ : μ"
set ylabel "{/:Italic p} = {/:Italic am} : {/:Italic b}"
set xrange [0:R_max > 3.2 ? 1.05 * R_max : 3.2]
set yrange [0:0.4]
set label "λ = 2μ:\nswings grow" at 2.05, 0.34 center textcolor linetype 2
set label "λ = μ" at 1.08, 0.34 left textcolor linetype 2
set label "such balances" at graph 0.02, first P_max + 0.02 left textcolor linetype 1
set label "Euler" at 0.37, 0.085 left textcolor linetype 7
plot for [name in "first second third"] tsv("balance-22." . name) using "from":"p" with lines linetype 2, \
     for [name in "first second third"] tsv("balance-22." . name) using "to":"p" with lines linetype 2, \
     tsv("balance-22.balances") using "ratio":"p" with lines linetype 1 linewidth 4, \
     "+" using (1. / 3):(1. / 12) every ::0::0 with points linetype 7
