# SPDX-License-Identifier: GPL-3.0-or-later
# Deflection and angle of the tip against wind speed.
#   gnuplot -c tip.gp FOLDER [FILE [LANGUAGE]]
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'tip.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
load HERE.'report_facts.gp'
KEY = 12.0 + 18*KEY_ROWS
WIDTH = 640.0; HEIGHT = 250.0 + KEY
load HERE.'start.gp'
set multiplot
set xrange [0:PER[SPEED]*SPEED_MAX]; set yrange [0:1e-3 < *] # a tree that does not move has an axis all the same
set xlabel sprintf(L('WIND'), typed(number('REFERENCE', 0), 'm'))
bottom = (52.0 + KEY)/HEIGHT
do for [panel=0:1] {
    NAME_Y = panel ? "tip_angle_deg" : "tip_deflection_m"; SCALE_Y = panel ? 1.0 : PER[LENGTH]
    set ylabel (panel ? L('TIP_ANGLE') : L('TIP_DEFLECTION')) offset 1,0
    x0 = panel ? 392.0 : 72.0
    set lmargin at screen x0/WIDTH; set rmargin at screen (x0 + 234)/WIDTH
    set tmargin at screen 1 - 14.0/HEIGHT; set bmargin at screen bottom
    plot for [i=1:trees] SWEEP using (pick(of(i) && column("wind_m_s") <= SPEED_MAX, PER[SPEED]*column("wind_m_s"))):(SCALE_Y*column(NAME_Y)) with lines lt i, \
         for [i=1:trees] SUMMARY using (pick(of(i) && strlen(SOLVED[i]) > 0, PER[SPEED]*column("wind_m_s"))):(SCALE_Y*column(NAME_Y)) with points lt i lw 1
}
load HERE.'strip.gp'
set key maxcols KEY_COLUMNS
plot 2 with lines, for [i=1:trees] keyentry with linespoints lt i title key_name(i)
unset multiplot
set output
