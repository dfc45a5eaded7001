load "figures/style.gp"
file = tsv("globe-08.motion")
array V[201]; array W[201]; array T[201]
stats file using (T[int($0) + 1] = column("t"), V[int($0) + 1] = column("v"), W[int($0) + 1] = column("aw")) nooutput
set xlabel "time (seconds)"
set ylabel "velocity (feet a second)"
set rmargin 4
set label "{/:Italic ds}/{/:Italic dt}" at T[20], V[20] offset 0.5, 0.8 left textcolor linetype 1
set label "{/:Italic a d}Φ/{/:Italic dt}" at T[20], W[20] offset 1, -0.6 left textcolor linetype 2
plot file using "t":"aw" with lines linetype 2, \
     file using "t":"v" with lines linetype 1
