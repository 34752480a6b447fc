# SPDX-License-Identifier: GPL-3.0-or-later
# Branches of springs without a law for their constants: under their weight, and after it was taken away.
#   gnuplot -c rain_order.gp FOLDER FILE LANGUAGE
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'rain_order.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
LINES = DIR.'/tables/order_lines.csv'
WIDTH = 640.0; HEIGHT = 330.0
load HERE.'start.gp'
set multiplot
mine(n, held, state) = column("prisms") == n && (column("restoring_N_m") > 0) == held && strcol("state") eq state
set xrange [-0.05*PER_M:0.85*PER_M]; set yrange [-0.9*PER_M:0.08*PER_M]
set xlabel L('RAIN_X') offset 0,0.3
do for [k=0:1] {
    set lmargin at screen (76.0 + 286.0*k)/WIDTH; set rmargin at screen (342.0 + 286.0*k)/WIDTH
    set tmargin at screen 1 - 30.0/HEIGHT; set bmargin at screen 56.0/HEIGHT
    set title (k ? L('RAIN_LET_GO') : L('RAIN_LOADED')) font ',10' offset 0,-0.5
    if (k) { unset ylabel; set format y ''; set key off } else { set ylabel L('RAIN_Z') offset 1,0; set format y '%g'; set key bottom right font ',9.5' samplen 2 }
    plot for [j=0:2] LINES using (pick(mine(8*2**j, 0, k ? 'free' : 'loaded'), PER_M*column("x_m"))):(PER_M*column("z_m")) with lines lt j+1 title sprintf(L('RAIN_N_FREE'), 8*2**j), \
         for [j=0:2] LINES using (pick(mine(8*2**j, 1, k ? 'free' : 'loaded'), PER_M*column("x_m"))):(PER_M*column("z_m")) with lines lt j+1 dt (4,3) title sprintf(L('RAIN_N_HELD'), 8*2**j)
}
unset multiplot
set output
