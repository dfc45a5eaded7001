load "figures/style.gp"
set xrange [0:100]
set lmargin 11
set xlabel "swings"
set ylabel "100 ({/:Italic C}′ : {/:Italic C} − 1)"
file = tsv("tautochrone-17.constants")
stats file using (100 * column("runge_kutta")) every ::900::900 name "R" nooutput
stats file using (100 * column("midpoint")) name "M" nooutput
set yrange [*:M_max + 0.35]
set label "midpoint rule" at 2, M_max + 0.15 left textcolor linetype 1
set label "Runge and Kutta" at 66, R_max - 0.1 right textcolor linetype 2
plot file using "swings":(100 * column("midpoint")) with points linetype 1 pointsize 0.25, \
     file using "swings":(100 * column("runge_kutta")) with lines linetype 2
