load "figures/style.gp"
file = tsv("globe-09.bowled")
array F[122]; array U[122]; array W[122]; array S[122]; array T[122]
stats file using (T[int($0) + 1] = column("t"), F[int($0) + 1] = column("forwards"), U[int($0) + 1] = column("upwards"), \
  W[int($0) + 1] = column("turning"), S[int($0) + 1] = column("sum")) nooutput
set xlabel "time (seconds)"
set ylabel "over the mass (feet² / second²)"
set xzeroaxis linetype 6
set label "{/:Italic kk dd}Φ" at T[20], W[20] offset 0, -0.9 left textcolor linetype 3
set label "{/:Italic y ddx}" at T[20], F[20] offset 0, -0.9 left textcolor linetype 2
set label "{/:Italic c ddy} sin Φ" at T[20], U[20] offset 0, 0.8 left textcolor linetype 4
set label "sum" at T[110], S[110] offset 0, -1 left textcolor linetype 1
plot file using "t":"forwards" with lines linetype 2, \
     file using "t":"turning" with lines linetype 3, \
     file using "t":"upwards" with lines linetype 4, \
     file using "t":"sum" with lines linetype 1
