load "figures/style.gp"
set xrange [0:1]
set yrange [-16:16]
set xlabel "v"
set ylabel "parts and sum"
set label "1/vv√(1−vv)" at 0.37, 9.2 left textcolor linetype 3
set label "{/:Italic l}(1+√(1−vv))/vv" at 0.09, 2.6 left textcolor linetype 4
set label "−(1+{/:Italic l} 2)/vv" at 0.42, -11.5 left textcolor linetype 2
set label "V" at 0.6, -1.3 left textcolor linetype 1
f = tsv("pendulum-23.parts")
plot f using "v":"first" with lines linetype 2, "" using "v":"second" with lines linetype 3, \
     "" using "v":"third" with lines linetype 4, "" using "v":"V" with lines linetype 1 linewidth 2.4
