# SPDX-License-Identifier: GPL-3.0-or-later
# Deflected shapes: one panel a tree, one line a wind speed, all on one true scale.
#   gnuplot -c shapes.gp FOLDER [FILE [LANGUAGE]]
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'shapes.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
load HERE.'report_facts.gp'

# Horizontal place along the wind, unloaded and loaded.
still(i) = column("x_m")*cos(AZIMUTH[i]) + column("y_m")*sin(AZIMUTH[i])
bent(i) = column("loaded_x_m")*cos(AZIMUTH[i]) + column("loaded_y_m")*sin(AZIMUTH[i])

TABLE = SHAPE
load HERE.'rows.gp'

# Branches, drawn row by row because the table does not lift the pen between axes: every row from the point
# before it, but for the first of an axis. A tree of very many rows shows its stem alone.
branched(i) = ROWS[i] <= 5000
px = 0.0; py = 0.0; ox = 0.0; oy = 0.0
from(is, x, y) = (ox = px, oy = py, px = x, py = y, is && column("axis") > 1 && column("segment") > 0 ? ox : NaN)

# A shape beyond the loss of the tree is grey: that of a tree that cannot be lost.
shade_of(n) = word('#0072B2 #D55E00 #009E73 #CC79A7 #E69F00 #56B4E9', (n - 1)%6 + 1)
shade(i, n) = WIND[n] > CRITICAL[i] ? '#b8b8b8' : shade_of(n)

low = 0.0; high = 0.0; top = 0.0; floor = 0.0
do for [i=1:trees] {
    top = HEIGHT_M[i] > top ? HEIGHT_M[i] : top
    if (strlen(SOLVED[i])) {
        stats SHAPE using (pick(of(i), bent(i))):(pick(of(i), column("loaded_z_m"))) name 'S' nooutput
        low = S_min_x < low ? S_min_x : low
        high = S_max_x > high ? S_max_x : high
        floor = S_min_y < floor ? S_min_y : floor
    }
}
top = 1.04*top
span = high - low > 0.35*top ? high - low : 0.35*top   # a stiff tree still gets a readable panel
low = low - 0.07*span; high = low + 1.16*span
floor = floor < 0 ? 1.03*floor : 0

# The panels: as many a row as make the trees largest within half a page.
LEFT = 58.0; GAP = 22.0; TITLE = 30.0; UNDER = 48.0; KEY = winds > 3 ? 50.0 : 30.0
wide_of(c) = (640.0 - LEFT - 12 - GAP*(c-1))/c
rows_of(c) = (trees + c - 1)/c
high_of(c) = (HIGH_C = 420.0/rows_of(c) - TITLE - UNDER, HIGH_C < 110 ? 110.0 : HIGH_C > 300 ? 300.0 : HIGH_C)
lesser(a, b) = a < b ? a : b
scale_of(c) = lesser(wide_of(c)/(high - low), (trees == 1 ? 210.0 : high_of(c))/(top - floor))
columns = 1
do for [c=2:(trees < 4 ? trees : 4)] { columns = scale_of(c) > 1.02*scale_of(columns) ? c : columns }
rows = rows_of(columns)
scale = scale_of(columns)
w = scale*(high - low); h = scale*(top - floor)
WIDTH = 640.0
side = 0.5*(WIDTH - (LEFT + 12 + GAP*(columns-1) + w*columns))
HEIGHT = rows*(h + TITLE + UNDER) + KEY
load HERE.'start.gp'

set multiplot
set xrange [low:high]; set yrange [floor:top]
# the smallest round step that leaves room for the figures
xstep = 1000.0; ystep = 1000.0
do for [s in "500 200 100 50 20 10 5 2 1 0.5 0.2 0.1 0.05 0.02 0.01"] {
    xstep = lengths(real(s))*scale >= 32 ? real(s) : xstep
    ystep = lengths(real(s))*scale >= 28 ? real(s) : ystep
}
set xtics xstep; set ytics ystep
do for [i=1:trees] {
    c = (i-1)%columns; r = (i-1)/columns
    x0 = side + LEFT + c*(w + GAP); y1 = HEIGHT - r*(h + TITLE + UNDER) - TITLE
    set lmargin at screen x0/WIDTH; set rmargin at screen (x0 + w)/WIDTH
    set tmargin at screen y1/HEIGHT; set bmargin at screen (y1 - h)/HEIGHT
    set title short(NAME[i], trees == 1 ? 560 : (640.0 - LEFT)/columns - 12) offset 0,-0.5
    set xlabel L('ALONG') offset 0,0.4
    if (turned) {
        set xtics ('0' 0); set ytics ((c ? '' : '0') 0)
        do for [k=-100:100] { set xtics add (tic(k*xstep) lengths(k*xstep)); set ytics add ((c ? '' : tic(k*ystep)) lengths(k*ystep)) }
    }
    if (c == 0) { set ylabel L('HEIGHT') offset 0.8,0; set format y '%g' } else { unset ylabel; set format y '' }
    plot for [n=1:branched(i)*words(SOLVED[i])] SHAPE every ::row_first(i, n)::row_last(i, n) using (from(at(i, WIND[nth(SOLVED[i], n)]), bent(i), column("loaded_z_m"))):(oy):(px - ox):(py - oy) with vectors nohead lt nth(SOLVED[i], n) lc rgb shade(i, nth(SOLVED[i], n)) lw 0.35 dt 1, \
         for [n=1:(words(SOLVED[i]) > 0)] SHAPE every ::row_first(i, n)::row_last(i, n) using (pick(at(i, WIND[nth(SOLVED[i], n)]) && column("axis") == 1, still(i))):"z_m" with lines lw 1.2 dt (3,4) lc rgb '#707070', \
         for [n=1:words(SOLVED[i])] SHAPE every ::row_first(i, n)::row_last(i, n) using (pick(at(i, WIND[nth(SOLVED[i], n)]) && column("axis") == 1, bent(i))):"loaded_z_m" with lines lt nth(SOLVED[i], n) lc rgb shade(i, nth(SOLVED[i], n)), \
         2*top with lines notitle   # above the picture: a tree without answers still gets its axes
}
# grey in the key where every tree is lost in that wind
kept(n) = (sum [i=1:trees] (WIND[n] > CRITICAL[i] ? 0 : 1)) > 0
load HERE.'strip.gp'
plot 2 with lines, keyentry with lines lw 1.2 dt (3,4) lc rgb '#707070' title L('STILL'), \
     for [k=1:winds] keyentry with lines lt k lc rgb (kept(k) ? shade_of(k) : '#b8b8b8') title speed(WIND[k])
unset multiplot
set output
