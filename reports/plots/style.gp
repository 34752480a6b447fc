# House style, loaded by every figure script. A script is called as
#   gnuplot -c SCRIPT FOLDER [FILE]
# FOLDER: a results folder of windfirm (tables/, plots/run.gp). FILE: *.pdf and *.png are drawn as such,
# anything else as SVG. Colours: Okabe & Ito 2008, safe for the colour-blind; lines also differ in dash and
# marker, so a copy in black and white can be read.
set encoding utf8
load DIR.'/plots/run.gp'
SUMMARY = DIR.'/tables/summary.csv'
SEGMENTS = DIR.'/tables/segments.csv'
SHAPE = DIR.'/tables/shape.csv'
SWEEP = DIR.'/tables/sweep.csv'
set datafile separator comma
set datafile columnheaders

set linetype 1 lc rgb '#0072B2' lw 1.6 dt 1          pt 7  ps 0.7
set linetype 2 lc rgb '#D55E00' lw 1.6 dt (14,5)     pt 5  ps 0.6
set linetype 3 lc rgb '#009E73' lw 1.6 dt (4,3)      pt 9  ps 0.75
set linetype 4 lc rgb '#CC79A7' lw 1.6 dt (14,4,3,4) pt 13 ps 0.8
set linetype 5 lc rgb '#E69F00' lw 2.4 dt 1          pt 11 ps 0.75
set linetype 6 lc rgb '#56B4E9' lw 1.6 dt (8,3,2,3,2,3) pt 4 ps 0.65
set linetype cycle 6
set border 3 lw 0.8 lc rgb '#404040'
set tics nomirror out scale 0.6 textcolor rgb '#202020'
set grid lw 0.5 lt 1 lc rgb '#e3e3e3' dt 1
set key top left Left reverse samplen 4 spacing 1.2 noautotitle
set minussign
set decimalsign '.'

# Start the picture, w by h pixels of a screen; a printed page takes 640 pixels across.
ends(name, tail) = strlen(name) >= strlen(tail) && name[strlen(name)-strlen(tail)+1:] eq tail
FONT = "DejaVu Sans,11"
if (ends(OUT, '.pdf')) {
    OPEN = "set terminal pdfcairo noenhanced color size %gin,%gin font '".FONT."' fontscale 0.62"
    PIXELS = 96.0
} else { if (ends(OUT, '.png')) {
    OPEN = "set terminal pngcairo noenhanced size %g,%g font '".FONT."'"
    PIXELS = 1.0
} else {
    OPEN = "set terminal svg noenhanced dynamic size %g,%g font '".FONT."'"
    PIXELS = 1.0
}}
start = "eval sprintf(OPEN, WIDTH/PIXELS, HEIGHT/PIXELS); set output OUT"

# The key stands in a strip of its own at the foot of the picture, as wide as the page: the last plot of a
# multiplot, entries alone. Its height is KEY pixels.
strip = "set lmargin at screen 0.02; set rmargin at screen 0.98; set bmargin at screen 0; set tmargin at screen KEY/HEIGHT; unset border; unset tics; unset grid; unset title; unset xlabel; unset ylabel; unset label; unset arrow; unset logscale; set xrange [0:1]; set yrange [0:1]; set key at graph 0.5, graph 0.5 center center horizontal Left reverse samplen 4 width 2"

# Rows of a table that belong to tree i at wind speed u; the value y elsewhere is not a number.
of(i) = column("tree") == i
at(i, u) = of(i) && abs(column("wind_m_s") - u) <= 1e-9*(1 + u)
pick(is, y) = is ? y : NaN
# The n-th number of a list; gnuplot evaluates a loop's body once even where the list is empty.
nth(list, n) = words(list) < n ? 1 : int(word(list, n))
