# The one style of all figures. A figure script is run by gnuplot from the repository root with two strings
# set: `data`, the folder of the programs' tables and curves, and `out`, the file to draw. It begins with
#     load "figures/style.gp"
# and then only plots. The ending of `out` chooses the form: .svg for the book; .pdf and .png on request.
#
# The colours stand here and nowhere else: the weaver reads them and gives the page a light and a dark one for
# each, both with enough contrast for text and told apart without colour vision.
#            name        light        dark
ink        = "#1f1b16" # ink          #e8e1d5   7  frames, letters, geometry
blue       = "#14479a" # blue         #5c9df5   1  what is exact
vermilion  = "#a83a08" # vermilion    #dd7f3c   2  what Euler has, where it differs
green      = "#1a7f6b" # green        #2fa57c   3
purple     = "#b03a9c" # purple       #d58bca   4
ochre      = "#8a7200" # ochre        #f3d25c   5  (dashed: near vermilion for some eyes)
grey       = "#6b665e" # grey         #a59d90   6  (thin) bounds, asymptotes, construction
faint      = "#ddd6c9" # faint        #3a352e      grid
paper      = "#fdfbf6" # paper        #181613      background: points and labels that must cover a line

width = 640; height = 400
if (exists("tall"))  height = 560   # set tall = 1 before loading, for geometry
if (exists("short")) height = 260

ending = out[strlen(out) - 2 :]
if (ending eq "svg") set terminal svg size width, height enhanced font "EB Garamond,17" \
  linewidth 1.2 dashlength 0.9
if (ending eq "pdf") set terminal pdfcairo size width / 100., height / 100. enhanced \
  font "EB Garamond,12" linewidth 1.2
if (ending eq "png") set terminal pngcairo size 2 * width, 2 * height enhanced \
  font "EB Garamond,24" linewidth 2.4
set output out

set encoding utf8
set minussign
set datafile separator tab
set datafile columnheaders          # so that columns have names: using "zeta":"ratio"
set datafile missing "nan"
tsv(name) = data . "/" . name . ".tsv"   # plot tsv("pendulum-11.ratio") using "zeta":"ratio"

set linetype 1 linecolor rgb blue      linewidth 1.6 pointtype 7 pointsize 0.5
set linetype 2 linecolor rgb vermilion linewidth 1.6 pointtype 9 pointsize 0.6
set linetype 3 linecolor rgb green     linewidth 1.6 pointtype 5 pointsize 0.45
set linetype 4 linecolor rgb purple    linewidth 1.6 pointtype 13 pointsize 0.6
set linetype 5 linecolor rgb ochre     linewidth 1.6 pointtype 11 pointsize 0.6 dashtype (8, 4)
set linetype 6 linecolor rgb grey      linewidth 0.9 pointtype 6 pointsize 0.5
set linetype 7 linecolor rgb ink       linewidth 1.0 pointtype 7 pointsize 0.5
set linetype cycle 7

set border 3 linecolor rgb ink linewidth 0.8
set tics nomirror out scale 0.5 textcolor rgb ink
set grid linetype 1 linecolor rgb faint linewidth 0.7 dashtype 1
set xlabel textcolor rgb ink
set ylabel textcolor rgb ink offset 1, 0
set style textbox opaque noborder fillcolor rgb paper margins 0.4, 0.2
set style fill transparent solid 0.18 noborder
unset key                            # write names on the lines: set label "exact" at x, y textcolor lt 1
