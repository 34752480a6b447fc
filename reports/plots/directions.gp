# SPDX-License-Identifier: GPL-3.0-or-later
# Winds from all around: base moment (left) and critical wind speed (right) by where the wind comes from.
#   gnuplot -c directions.gp FOLDER [FILE [LANGUAGE]]
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'directions.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
load HERE.'report_facts.gp'
AROUND = DIR.'/tables/directions.csv'
KEY = 12.0 + 18*(trees == 1 ? 2 : KEY_ROWS)
WIDTH = 640.0; HEIGHT = 280.0 + KEY
U = number('WIND_LAST', 0)
load HERE.'start.gp'
set multiplot
set size ratio -1
unset border; unset tics; unset grid
# ring distance for a largest value: three to five rings of a round number
ring(x) = (t = 10.0**floor(log10(x/2.5)), x/t <= 5 ? t : x/t <= 10 ? 2*t : 5*t)
set trange [0:2*pi]; set samples 181
known(x) = x == x ? x : -1
stats AROUND using (abs(column("wind_m_s") - U) <= 1e-9*(1 + U) ? known(column("base_moment_Nm"))/1e3 : -1) name 'M' nooutput
# the loss of the tree and, of one tree, the part that breaks first; results that do not know the loss: that part and the stem
array COLUMN[3] = ["base_moment_Nm", LOSS_KNOWN[1] ? "lost_wind_m_s" : "critical_wind_m_s", LOSS_KNOWN[1] ? "critical_wind_m_s" : "stem_critical_wind_m_s"]
stats AROUND using (known(column(COLUMN[2]))) name 'C' nooutput
stats AROUND using (known(column(COLUMN[3]))) name 'S' nooutput
array TOP[2] = [M_max > 0 ? PER[MOMENT]*M_max : 1, C_max > 0 ? PER[SPEED]*C_max : 1]
if (trees == 1 && PER[SPEED]*S_max > TOP[2]) { TOP[2] = PER[SPEED]*S_max }
array TITLE[2] = [sprintf(L('AROUND_MOMENT'), said(SPEED, number('WIND_LAST', 0)).' '.UNIT[SPEED]), L('AROUND_CRITICAL')]
array SCALE[3] = [1e-3*PER[MOMENT], PER[SPEED], PER[SPEED]]
stats AROUND using (at(1, U) ? 1 : NaN) name 'N' nooutput
COUNT = int(N_records)
# figures of the rings stand between two directions, away from north
SECTOR = COUNT ? 360.0/COUNT : 45.0; MID = SECTOR*(ceil(20/SECTOR - 0.5) + 0.5)*pi/180
do for [p=1:2] {
    unset label; unset arrow; unset object; unset key
    STEP = ring(TOP[p]); RINGS = ceil(TOP[p]/STEP - 1e-9); E = RINGS*STEP
    set xrange [-1.25*E:1.25*E]; set yrange [-1.25*E:1.25*E]
    set lmargin at screen 0.01 + 0.5*(p - 1); set rmargin at screen 0.49 + 0.5*(p - 1)
    set tmargin at screen 1 - 40.0/HEIGHT; set bmargin at screen (KEY + 4)/HEIGHT
    set title TITLE[p] offset 0,0.2
    FOUND = p == 1 || C_max > 0 || (trees == 1 && S_max > 0)
    if (!FOUND) { RINGS = 1; STEP = E; set label L('AROUND_NONE') at 0,0 center front }
    do for [j=1:(FOUND ? RINGS : 0)] {
        set object rectangle center first j*STEP*sin(MID), j*STEP*cos(MID) size first 0.075*E*strlen(sprintf('%g', j*STEP)), 0.13*E front fs solid noborder fc rgb '#ffffff'
        set label sprintf('%g', j*STEP) at first j*STEP*sin(MID), j*STEP*cos(MID) center front textcolor rgb '#606060'
    }
    do for [k=1:4] {
        set arrow from 0,0 to E*sin(k*pi/2), E*cos(k*pi/2) nohead lw 0.6 lc rgb '#dcdcdc' dt 1 back
    }
    set label L('NORTH') at first 0, 1.1*E center; set label L('SOUTH') at first 0, -1.1*E center
    set label L('EAST') at first 1.1*E, 0 center; set label L('WEST') at first -1.1*E, 0 center
    do for [i=1:trees] {
        do for [q=p:(p == 2 && trees == 1 ? 3 : p)] {
            LINE = q == 3 ? 2 : i
            xo = NaN; yo = NaN
            do for [k=0:COUNT] {
                a = 360.0*(k % COUNT)/COUNT
                stats AROUND using (at(i, U) && abs(column("from_deg") - a) < 1e-3 ? known(column(COLUMN[q]))*SCALE[q] : NaN) name 'V' nooutput
                r = V_max > 0 ? V_max : NaN
                x = r*sin(a*pi/180); y = r*cos(a*pi/180)
                if (x == x && xo == xo) { set arrow from xo,yo to x,y nohead lt LINE back } # behind the figures of the rings
                if (x == x) { set label '' at x,y point lt LINE front }
                xo = x; yo = y
            }
        }
    }
    set parametric
    plot for [j=1:RINGS] j*STEP*cos(t), j*STEP*sin(t) with lines lw 0.6 lc rgb '#c8c8c8' dt 1
    unset parametric
}
load HERE.'strip.gp'
set size noratio
if (trees == 1) {
    # the lines of the right picture have names, below it; that of the left one is what its title says
    set lmargin at screen 0.51; set rmargin at screen 0.99
    set key maxcols 1
    plot 2 with lines, \
         for [n=1:(C_max > 0)] keyentry with linespoints lt 1 title L(LOSS_KNOWN[1] ? 'AROUND_LOST' : 'AROUND_FIRST'), \
         for [n=1:(S_max > 0)] keyentry with linespoints lt 2 title L(LOSS_KNOWN[1] ? 'AROUND_FIRST' : 'AROUND_STEM')
} else {
    set key maxcols KEY_COLUMNS
    plot 2 with lines, for [i=1:trees] keyentry with linespoints lt i title key_name(i)
}
unset multiplot
set output
