load "figures/style.gp"
set xrange [0:2]
set xlabel "half turns of the beam, λ{/:Italic t}/π"
set ylabel "beside the regular swing, minutes" offset 0, 0
set xzeroaxis linetype 6
file = tsv("balance-18.strays")
stats file using "turn":"P" name "P" nooutput
stats file using "turn":"Q" name "Q" nooutput
most = P_max_y > Q_max_y ? P_max_y : Q_max_y
least = P_min_y < Q_min_y ? P_min_y : Q_min_y
reach = most > -least ? most : -least
if (reach == 0) reach = 1
set lmargin (reach < 1e-3 || reach > 1e5 ? 14 : 9)
set yrange [-1.15 * reach:1.15 * reach]
# In an eighth of a turn there is one highest place, and none as high.
stats [0:0.25] file using "turn":"P" name "P_first" nooutput
stats [0:0.25] file using "turn":"Q" name "Q_first" nooutput
set label "P" at P_first_pos_max_y, P_first_max_y + 0.08 * reach center textcolor linetype 1
set label "Q" at Q_first_pos_max_y, Q_first_max_y + 0.08 * reach center textcolor linetype 3
plot file using "turn":"P" with lines linetype 1, "" using "turn":"Q" with lines linetype 3
