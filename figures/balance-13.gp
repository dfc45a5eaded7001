load "figures/style.gp"
set xrange [0:360]
set yrange [-0.018:0.018]
set xtics 60 format "%g°"
set ytics 0.01 format "%g"
set xlabel "time as an angle, λt"
set ylabel "part of {/:Italic dd}η : {/:Italic dt}^2 (1/s^2)" offset 0, 0
set lmargin 11
set label "kept" at 16, 0.0155 left textcolor linetype 1
set label "dropped" at 92, 0.0155 left textcolor linetype 2
plot 0 with lines linetype 6, \
     tsv("balance-13.terms") using "lambda_t":"kept" with lines linetype 1, \
     "" using "lambda_t":"dropped" with lines linetype 2
