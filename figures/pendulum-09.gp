load "figures/style.gp"
set logscale xy
set xrange [0.25:16]
lengths = tsv("pendulum-09.lengths")
array amplitude[4] = ["ζ = 0°", "90°", "150°", "175°"]
do for [i = 1:4] {
  stats lengths using i + 1 nooutput
  set label amplitude[i] at 17, 1.02 * STATS_max offset 0, (i == 1 ? -0.3 : i == 2 ? 0.3 : 0) textcolor linetype 1
  if (i == 1) { low = 2 ** floor(log(STATS_min) / log(2)) }  # whole octaves, as g has it
  if (i == 4) { high = 2 ** ceil(log(STATS_max) / log(2)) }
}
set yrange [low:high]
set logscale xy 2
set format "%g"
set rmargin 9
set xlabel "length {/:Italic b} (feet)"
set ylabel "time of one swing {/:Italic T} (seconds)"
beat = tsv("pendulum-09.beat")
stats beat using 1 nooutput
left = STATS_max > 4  # where the lines leave room
if (low < 1 && high > 1) {
  set arrow from 0.25, 1 to 16, 1 nohead linetype 6
  set label "one second" at (left ? 0.27 : 5), (left ? 1.1 : 0.9) textcolor linetype 6
}
inside(b) = b < 0.25 || b > 16 ? NaN : b
plot for [i = 2:5] lengths using 1:i with lines linetype 1, \
     beat using (inside(column("b"))):(1) with points linetype 2 pointtype 7 pointsize 0.7
