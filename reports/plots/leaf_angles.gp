# SPDX-License-Identifier: GPL-3.0-or-later
# How one leaf turns on its stalk in time, run by run: in proportion to the wind (eq13), or by three noises.
#   gnuplot -c leaf_angles.gp FOLDER [FILE [LANGUAGE]]
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'leaf_angles.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
load HERE.'series_facts.gp'
ANGLES = DIR.'/tables/leaf_angles.csv'
SHOWS = ""
do for [r=1:RUNS] { if (FRAMES[r] > 1 && LEAVES[r] > 0 && words(SHOWS) < 6) { SHOWS = SHOWS.r." " } }
PANELS = words(SHOWS)
NOISE = 0; SWING = 0
do for [r in SHOWS] { if (MOTION[int(r)] eq 'noise') { NOISE = 1 } else { SWING = 1 } }
WIDTH = 640.0; ROW = PANELS > 4 ? 46.0 : 60.0; KEY = 44.0; HEIGHT = PANELS*(ROW + 12) + 48 + KEY
# the first leaf's rows: run, time, angles; a motion without an angle leaves it empty
set table $LEAF separator comma
plot ANGLES using (column("run")):(column("time_s")):(strcol("swing_deg")):(strcol("twist_deg")):(strcol("theta_x_deg")):(strcol("theta_y_deg")):(strcol("theta_z_deg")) with table if (column("leaf") == 1)
unset table
set datafile nocolumnheaders
load HERE.'start.gp'
set multiplot
set lmargin at screen 82.0/WIDTH; set rmargin at screen 625.0/WIDTH
set ytics 30 font ",9.5"; set xtics font ",9.5"; set format x ""
set ylabel L('DEGREES') font ",9.5"
do for [p=1:PANELS] {
    r = nth(SHOWS, p); y1 = HEIGHT - 8 - (p - 1)*(ROW + 12)
    set tmargin at screen y1/HEIGHT; set bmargin at screen (y1 - ROW)/HEIGHT
    set label 1 short(NAME[r], 440) at graph 0.995, graph 0.88 right font ",9.5"
    if (p == PANELS) { set format x "%g"; set xlabel L('TIME') font ",9.5" }
    set xrange [0:FRAMES[r]*STEP[r]]
    first = MOTION[r] eq 'noise' ? 3 : 1
    plot for [c=first:(MOTION[r] eq 'noise' ? 5 : 2)] $LEAF using (pick($1 == r, $2)):(column(c + 2)) with lines lt c lw 1.2
}
load HERE.'strip.gp'
set key maxcols 5 width 0
plot for [c=(SWING ? 1 : 3):(NOISE ? 5 : 2)] -1 with lines lt c title L(sprintf('LEAF_%d', c))
unset multiplot
set output
