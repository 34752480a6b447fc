# SPDX-License-Identifier: GPL-3.0-or-later
# A wind rose: how much of the time the wind comes from each direction, by strength.
#   gnuplot -c wind_rose.gp FOLDER [FILE [LANGUAGE]]
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'wind_rose.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
SECTORS = int(number('SECTORS', 0))
ROSE = DIR.'/tables/rose.csv'
WIDTH = 640.0; HEIGHT = 500.0
array COLOUR[5] = ['#dfe9f2', '#a9c9e2', '#5f9fcf', '#2b6cab', '#0b2f5e']
above(k) = k == 1 ? L('ROSE_ALL') : sprintf(L('ROSE_ABOVE'), typed(5*(k - 1), 'm/s'))
stats ROSE using 2 nooutput
TOP = STATS_max
TEN = 10.0**floor(log10(TOP/2)); RING = TOP/2/TEN > 5 ? 5*TEN : TOP/2/TEN > 2 ? 2*TEN : TEN
WIDE = 180.0/SECTORS*0.92
RINGS = ceil(TOP/RING - 1e-9); MOST = RINGS*RING
do for [i=1:SECTORS] {
    stats ROSE every ::(i-1)::(i-1) using 1 nooutput
    AT = 90 - STATS_max
    do for [k=1:5] {
        stats ROSE every ::(i-1)::(i-1) using (k == 1 ? column(2) : column(k + 3)) nooutput
        R = STATS_max
        if (R > 0.002*TOP) {
            set object circle at 0,0 size first R arc [AT-WIDE:AT+WIDE] fillcolor rgb COLOUR[k] fillstyle solid 1 border lc rgb '#3c5a78' lw 0.6 front
        }
    }
}
# figures of the rings, within the second sector, so that no edge of a sector crosses them
stats ROSE every ::1::1 using 1 nooutput
AT = (90 - STATS_max)*pi/180
do for [j=1:RINGS] {
    set label sprintf("%g%%", 100*j*RING) at first (j*RING - 0.04*MOST)*cos(AT), (j*RING - 0.04*MOST)*sin(AT) center front font ',14' textcolor rgb '#202020'
}
E = 1.08*MOST
set label L('NORTH') at first 0, E center font ',14'; set label L('SOUTH') at first 0, -E center font ',14'
set label L('EAST') at first E, 0 center font ',14'; set label L('WEST') at first -E, 0 center font ',14'
load HERE.'start.gp'
set size ratio -1
unset border; unset tics; unset grid
set xrange [-1.14*MOST:1.14*MOST]; set yrange [-1.14*MOST:1.14*MOST]
set lmargin at screen 0.02; set rmargin at screen 0.78; set tmargin at screen 0.98; set bmargin at screen 0.02
set key at screen 0.985, screen 0.9 right top Left reverse font ',14'
set parametric; set trange [0:2*pi]; set samples 181
plot for [j=1:RINGS] j*RING*cos(t), j*RING*sin(t) with lines lw 0.8 lc rgb '#c8c8c8' dt 1, \
     for [k=1:5] keyentry with boxes fs solid 1 border lc rgb '#3c5a78' dt 1 lw 0.6 fc rgb COLOUR[k] title above(k)
set output
