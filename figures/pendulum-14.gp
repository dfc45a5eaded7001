load "figures/style.gp"
set logscale xy
set xrange [0.08:180]
set yrange [0.4:20000]
set xtics (0.1, 0.3, 1, 3, 10, 30, 90, 180) format "%g°"
set ytics 10 format "10^{%T}"
set xlabel "angle from the top ψ"
set ylabel "d{/:Italic t}/dψ, in √({/:Italic b}/2{/:Italic g})"
set label "η = 0.1°" at 0.115, 8000 textcolor linetype 1
set label "1°" at 1.1, 800 textcolor linetype 1
set label "5°" at 5.4, 150 textcolor linetype 1
set label "½ : sin ½ψ" at 0.25, 120 right textcolor linetype 2
plot tsv("pendulum-14.limit") using "psi":"element" with lines linetype 2 dashtype (6, 4), \
     tsv("pendulum-14.elements") using "psi":"element" with lines linetype 1
