# SPDX-License-Identifier: GPL-3.0-or-later
# Coverage of every slab and what its cells are, windward first, seen along the wind; wind that passes.
#   gnuplot -c shelter_slabs.gp FOLDER [FILE [LANGUAGE]]
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'shelter_slabs.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
LEFT = number('LEFT', 0); WIDE = number('WIDE', 0); BOTTOM = number('BOTTOM', 0); TALL = number('TALL', 0); DEPTH = number('DEPTH', 0)
SLABS = int(number('SLABS', 0))
CELLTABLE = DIR.'/tables/cells.csv'
SLABTABLE = DIR.'/tables/slabs.csv'
# at most 32 maps; with more slabs every second, third ... is shown
STEP = int(ceil(SLABS/32.0))
SHOWN = int((SLABS - 1)/STEP) + 1
# narrow maps stand sixteen in a row; the whole is no taller than a page
COLUMNS = TALL > 1.1*WIDE ? 12 : 6
COLUMNS = SHOWN < COLUMNS ? (SHOWN < 4 ? 4 : SHOWN) : COLUMNS
ROWS = int((SHOWN - 1)/COLUMNS) + 1
WIDTH = 640.0
BAR = 76.0   # room of the colour bar, right of the maps
CELL = (WIDTH - 12.0 - BAR)/COLUMNS
MAPW = CELL - 6.0
MOST = (1120.0 - 220 - 60)/(2*ROWS) - 16
MOST = MOST > 88 ? 88.0 : MOST
MAPH = MAPW*TALL/WIDE; MAPH = MAPH > MOST ? MOST : MAPH < 30 ? 30.0 : MAPH
MAPW = MAPH*WIDE/TALL < MAPW ? MAPH*WIDE/TALL : MAPW; CELL = MAPW + 8.0
BLOCK = ROWS*(MAPH + 16.0) + 30.0
HEIGHT = 2*BLOCK + 220.0
load HERE.'start.gp'
set multiplot
unset key; unset grid; unset tics; unset xlabel; unset ylabel
set border 15 lw 0.5 lc rgb '#b0b0b0'
set xrange [LEFT:LEFT+WIDE]; set yrange [BOTTOM:BOTTOM+TALL]
# the column names stand once, before the first block
unset datafile columnheaders
do for [part=1:2] {
    TOP = 22.0 + (part - 1)*BLOCK
    set label 1 (part == 1 ? sprintf(L('SLABS_COVERAGE'), three(DEPTH, 'm'), three(WIDE, 'm'), three(TALL, 'm')) : L('SLABS_CELLS')) at screen 0.015, screen 1 - (TOP - 11)/HEIGHT left
    if (part == 1) {
        set palette defined (0 '#ffffff', 0.02 '#e7efe2', 0.25 '#a5c48d', 0.6 '#4f8a4b', 1 '#123d1c'); set cbrange [0:1]
    } else {
        set palette maxcolors 5 defined (0 '#ffffff', 1 '#8fc1e3', 2 '#D55E00', 3 '#E69F00', 4 '#202020'); set cbrange [-0.5:4.5]
    }
    do for [n=0:SHOWN-1] {
        slab = 1 + n*STEP
        col = n % COLUMNS; row = n/COLUMNS
        set lmargin at screen (12.0 + col*CELL)/WIDTH; set rmargin at screen (12.0 + col*CELL + MAPW)/WIDTH
        y = TOP + 12.0 + row*(MAPH + 16.0)
        set tmargin at screen 1 - y/HEIGHT; set bmargin at screen 1 - (y + MAPH)/HEIGHT
        set label 2 sprintf("%d", slab) at graph 0.04, graph 0.93 left front textcolor rgb '#505050' font ",9.5"
        unset colorbox
        if (n == 0 && part == 1) {
            set colorbox vertical user origin (16.0 + COLUMNS*CELL)/WIDTH, 1 - (TOP + 12 + MAPH)/HEIGHT size 9.0/WIDTH, MAPH/HEIGHT
            set cbtics ('0' 0, '0.5' 0.5, L('CELL_FULL') 1) scale 0.3 font ",9.5" textcolor rgb '#202020'
        }
        plot CELLTABLE index slab-1 every ::(slab == 1) using 2:3:(part == 1 ? $4 : $5) with image
        unset label 1
    }
    unset colorbox
}
unset label 1; unset label 2
set datafile columnheaders
# key of the classes
TOP = 2*BLOCK + 2.0
set label 11 '■ '.L('CELL_CYLINDER') at screen 0.05, screen 1 - TOP/HEIGHT left textcolor rgb '#5f9fcf'
set label 12 '■ '.L('CELL_HOLE') at screen 0.18, screen 1 - TOP/HEIGHT left textcolor rgb '#D55E00'
set label 13 '■ '.L('CELL_SLIT') at screen 0.28, screen 1 - TOP/HEIGHT left textcolor rgb '#C08000'
set label 14 '■ '.L('CELL_TRANSMITTING') at screen 0.37, screen 1 - TOP/HEIGHT left textcolor rgb '#202020'
set label 15 L('CELL_NONE') at screen 0.54, screen 1 - TOP/HEIGHT left textcolor rgb '#707070'
set lmargin at screen 72.0/WIDTH; set rmargin at screen 0.96
set tmargin at screen 1 - (TOP + 28)/HEIGHT; set bmargin at screen 52.0/HEIGHT
set border 3 lw 0.8 lc rgb '#404040'; set tics nomirror out scale 0.6; set grid lw 0.5 lt 1 lc rgb '#e3e3e3' dt 1
set xtics nomirror autofreq; set ytics nomirror autofreq
set key bottom left
set xlabel L('FROM_FRONT') offset 0,0.2; set ylabel L('OF_UNDISTURBED') offset 0,0
set xrange [0:PER_M*DEPTH]; set yrange [*:1.02]
plot SLABTABLE using (PER_M*column("front_m")):(column("flux_ratio")) with lines lt 1 title L('FLUX'), \
     SLABTABLE using (PER_M*column("front_m")):(column("arriving_ratio")) with lines lt 2 title L('MEAN_WIND')
unset multiplot
set output
