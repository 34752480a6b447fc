# SPDX-License-Identifier: GPL-3.0-or-later
# Key frames as small panels, seen across the wind, which blows to the right; grey: the tree without wind, dashed:
# the plumb line of its height.
#   gnuplot -c frames.gp FOLDER [FILE [LANGUAGE [RUN]]]     RUN 0: the runs of one key frame
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'frames.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'
SHOWN = ARGC > 3 ? int(ARG4) : 0
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
load HERE.'series_facts.gp'
SINGLE = ""
do for [r=1:RUNS] { if (KEYS[r] == 1) { SINGLE = SINGLE.r." " } }
PANELS = SHOWN > 0 ? KEYS[SHOWN] : words(SINGLE)
RUN_OF(p) = SHOWN > 0 ? SHOWN : nth(SINGLE, p)
KEY_OF(p) = SHOWN > 0 ? p : 1
low = 0.0; high = 0.0; top = 0.0; leafy = 0
do for [p=1:PANELS] {
    low = LEFT[RUN_OF(p)] < low ? LEFT[RUN_OF(p)] : low
    high = RIGHT[RUN_OF(p)] > high ? RIGHT[RUN_OF(p)] : high
    top = TOP[RUN_OF(p)] > top ? TOP[RUN_OF(p)] : top
    leafy = leafy || LEAVES[RUN_OF(p)] > 0
}
# What is to be drawn, read once: run, key, level, base and way to the end
wanted(r, k) = SHOWN > 0 ? r == SHOWN : k <= 1
set table $WOOD separator comma
plot DIR.'/tables/frames.csv' using (column("run")):(column("key")):(column("level")):(PER_M*column("along0_m")):(PER_M*column("z0_m")):(PER_M*(column("along1_m")-column("along0_m"))):(PER_M*(column("z1_m")-column("z0_m"))) with table if (wanted(column("run"), column("key")))
unset table
if (leafy) {
    set table $LEAF separator comma
    plot DIR.'/tables/leaves.csv' using (column("run")):(column("key")):(0):(PER_M*column("along0_m")):(PER_M*column("z0_m")):(PER_M*(column("along1_m")-column("along0_m"))):(PER_M*(column("z1_m")-column("z0_m"))) with table if (wanted(column("run"), column("key")))
    unset table
}
set datafile nocolumnheaders
of(r, k) = $1 == r && $2 == k
set style arrow 1 nohead lc rgb '#14324a' lw 2.2
set style arrow 2 nohead lc rgb '#14324a' lw 1.1
set style arrow 3 nohead lc rgb '#14324a' lw 0.6
# beyond breakage: that of a tree that cannot break
set style arrow 4 nohead lc rgb '#b0b0b0' lw 2.2
set style arrow 5 nohead lc rgb '#b0b0b0' lw 1.1
set style arrow 6 nohead lc rgb '#b0b0b0' lw 0.6
broken(r, k) = number(sprintf('KEY_BROKEN_%d', r), k) == 1
margin = 0.04*top; low = low - margin; high = high + margin; top = 1.04*top
if (high - low < 0.3*top) { middle = 0.5*(low + high); low = middle - 0.15*top; high = middle + 0.15*top }
COLUMNS = PANELS < 4 ? PANELS : 4
LINES = ceil(PANELS/(1.0*COLUMNS))
WIDTH = 640.0
# the same scale both ways
WIDE = (WIDTH - 66)/COLUMNS - 10; TALL = WIDE*top/(high - low)
most = LINES == 2 ? 132.0 : (LINES > 2 ? 400.0 : 420.0)/LINES - 46;   # of two lines two figures go on a page
most = most > 300 ? 300.0 : most
if (TALL > most) { TALL = most }
WIDE = TALL/top*(high - low)
HEIGHT = LINES*(TALL + 46) + 26
load HERE.'start.gp'
set multiplot
unset key; unset grid
set border 1 lw 0.6
set xtics format "%g" scale 0.4 font ",9.5"; set ytics format "%g" scale 0.4 font ",9.5"
TICK = (high - low) > 30 ? 10.0 : (high - low) > 12 ? 5.0 : (high - low) > 5 ? 2.0 : (high - low) > 2 ? 1.0 : 0.5
set xtics TICK
do for [p=1:PANELS] {
    c = (p - 1) % COLUMNS; l = (p - 1)/COLUMNS
    x0 = 60 + c*((WIDTH - 66)/COLUMNS); y1 = HEIGHT - 24 - l*(TALL + 46)
    set lmargin at screen x0/WIDTH; set rmargin at screen (x0 + WIDE)/WIDTH
    set tmargin at screen y1/HEIGHT; set bmargin at screen (y1 - TALL)/HEIGHT
    set xrange [low:high]; set yrange [0:top]
    r = RUN_OF(p); k = KEY_OF(p)
    set title (SHOWN > 0 ? sprintf('%.3g s, ', number(sprintf('KEY_TIME_%d', r), k)).three(number(sprintf('KEY_WIND_%d', r), k), 'm/s') : two_lines(NAME[r], 1.2*((WIDTH - 50)/COLUMNS - 10))) font ",10" offset 0,-0.9
    set xlabel (l == LINES - 1 ? L('ALONG') : '') font ',9.5' offset 0,0.6; set ylabel (c == 0 ? L('HEIGHT') : '') font ',9.5' offset 0.3,0
    if (c == 0) { set border 3; set ytics nomirror scale 0.4 font ",9.5" autofreq } else { set border 1; unset ytics }
    set arrow 1 from 0,0 to 0,HEIGHT_M[r] nohead front dt (4,4) lc rgb '#606060' lw 0.9
    BEYOND = broken(r, k) ? 3 : 0
    if (LEAVES[r] > 0) {
        plot $WOOD using (pick(of(r, 0), $4)):5:6:7 with vectors nohead lc rgb '#c8c8c8' lw 0.8 dt 1, \
            $LEAF using (pick(of(r, k), $4)):5:6:7 with vectors nohead lc rgb (BEYOND ? '#d0d0d0' : '#7fbf9f') lw 0.5 dt 1, \
            $WOOD using (pick(of(r, k), $4)):5:6:7:(($3 < 2 ? $3 + 1 : 3) + BEYOND) with vectors arrowstyle variable
    } else {
        plot $WOOD using (pick(of(r, 0), $4)):5:6:7 with vectors nohead lc rgb '#c8c8c8' lw 0.8 dt 1, \
            $WOOD using (pick(of(r, k), $4)):5:6:7:(($3 < 2 ? $3 + 1 : 3) + BEYOND) with vectors arrowstyle variable
    }
}
unset multiplot
set output
