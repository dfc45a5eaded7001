load "figures/style.gp"
set logscale xy
set xrange [0.25:16]
lengths = tsv("pendulum-09.lengths")
array amplitude[4] = ["ζ = 0°", "90°", "150°", "175°"]
do for [i = 1:4] {
  stats lengths using i + 1 nooutput
  set label amplitude[i] at 17, 1.02 * STATS_max textcolor linetype 1
  if (i == 1) { octave = 2 ** floor(log(STATS_max / 2) / log(2) + 0.5) }  # the frame goes with g
}
set yrange [0.25 * octave:8 * octave]
set xtics (0.25, 0.5, 1, 2, 4, 8, 16)
set ytics (0.25 * octave, 0.5 * octave, 1 * octave, 2 * octave, 4 * octave, 8 * octave)
set rmargin 9
set xlabel "length {/:Italic b} (feet)"
set ylabel "time of one swing {/:Italic T} (seconds)"
set arrow from 0.25, 1 to 16, 1 nohead linetype 6
if (octave < 4) set label "one second" at 5, 0.9 textcolor linetype 6
plot for [i = 2:5] lengths using 1:i with lines linetype 1, \
     tsv("pendulum-09.beat") using "b":(1) with points linetype 2 pointtype 7 pointsize 0.7
