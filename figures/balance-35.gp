load "figures/style.gp"
file = tsv("balance-35.tones")
stats file using "frequency" every ::0::2 name "X" nooutput
wide = X_max - X_min
set xrange [X_min - 0.3 * wide:X_max + 0.35 * wide]
stats file using "eta_by_him" every ::0::2 name "E" nooutput
stats file using "eta" every ::0::2 name "C" nooutput
stats file using "eta" every ::0::0 name "L" nooutput
stats file using "eta_by_him" every ::0::0 name "H" nooutput
stats file using "eta" every ::3::3 name "F" nooutput
both = L_max + F_max
most = 720 * (E_max > C_max ? E_max : C_max)
least = 720 * (E_min < C_min ? E_min : C_min)
if (720 * both > most) most = 720 * both
if (720 * both < least) least = 720 * both
if (most < 0) most = 0
if (least > 0) least = 0
high = most - least
if (high == 0) high = 1
set yrange [least - 0.2 * high:most + 0.3 * high]
set xlabel "frequency (1/s)"
set lmargin (high < 1e-3 || high > 1e5 ? 14 : 10)
set ylabel "beside the regular swing, in 720ths" offset 0, 0
set xzeroaxis linetype 6
apart = 0.025 * wide
set label "by Euler" at X_min - apart, 720 * H_max + (H_max < 0 ? -0.08 : 0.08) * high center textcolor linetype 2
set label "complete" at X_min, 720 * both + (both < 0 ? -0.08 : 0.08) * high left textcolor linetype 1
plot file every ::0::2 using (column("frequency") - apart):(720 * column("eta_by_him")) with impulses linetype 2 linewidth 8, \
     file every ::1::2 using (column("frequency") + apart):(720 * column("eta")) with impulses linetype 1 linewidth 8, \
     file every ::0::0 using (column("frequency") + apart):(720 * both) with impulses linetype 1 linewidth 8
