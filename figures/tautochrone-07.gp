tall = 1
load "figures/style.gp"
set size ratio -1
unset border; unset tics; unset grid
paths = tsv("tautochrone-07.paths")
corners = tsv("tautochrone-07.corners")
stats corners using "i" name "N" nooutput
N = int(N_max)
array X[N + 1]; array Y[N + 1]; array R[N + 1]; array S[N + 2]
do for [i = 0:N] {
  stats corners every ::i::i using "aside" nooutput
  X[i + 1] = STATS_min
  stats corners every ::i::i using "down" nooutput
  Y[i + 1] = -STATS_min
  stats corners every ::i::i using "r" nooutput
  R[i + 1] = STATS_min
  stats corners every ::i::i using "since" nooutput
  S[i + 1] = STATS_min
}
stats paths using "phi" name "P" nooutput
stats paths using "arcs_aside" name "G" nooutput
S[N + 2] = P_max
set angles degrees
set xrange [-0.08:G_max + 0.1]
set yrange [-1.06:0.08]
do for [i = 1:N + 1] {
  # the first and the last radius of the arc about this corner
  set arrow from X[i], Y[i] to X[i] + R[i] * sin(S[i]), Y[i] - R[i] * cos(S[i]) nohead linetype 6
  set arrow from X[i], Y[i] to X[i] + R[i] * sin(S[i + 1]), Y[i] - R[i] * cos(S[i + 1]) nohead linetype 6
  if (N < 7) {
    set label sprintf("{/:Italic V}_%d", i - 1) at X[i] + 0.015, Y[i] + 0.03 left textcolor linetype 2
  }
}
arc(phi) = floor(sum [i = 1:N + 1] (phi >= S[i]))
odd(phi, x) = int(arc(phi)) % 2 == 1 ? x : NaN
even(phi, x) = int(arc(phi)) % 2 == 0 ? x : NaN
plot paths using "q":(-column("p")) with lines linetype 6 dashtype 3, \
     corners using "aside":(-column("down")) with linespoints linetype 2, \
     paths using (odd(column("phi"), column("arcs_aside"))):(-column("arcs_down")) with lines linetype 1 linewidth 3, \
     paths using (even(column("phi"), column("arcs_aside"))):(-column("arcs_down")) with lines linetype 3 linewidth 1.4, \
     paths using "aside":(-column("down")) with lines linetype 7 dashtype 3
