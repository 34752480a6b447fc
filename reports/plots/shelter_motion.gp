# SPDX-License-Identifier: GPL-3.0-or-later
# The tree bent in the open and in its own shelter, and how far its windward and leeward branches move.
#   gnuplot -c shelter_motion.gp FOLDER [FILE [LANGUAGE]]
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'shelter_motion.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
SPEED = number('SPEED', 0); LAW = text_of('LAW', 0)
ROWTABLE = DIR.'/tables/rows.csv'
TIPTABLE = DIR.'/tables/tips.csv'
stats ROWTABLE using (PER_M*column("open1_m")):(PER_M*column("up1_m")) nooutput
RIGHT = STATS_max_x; TOPMOST = STATS_max_y
stats ROWTABLE using (PER_M*column("along1_m")) nooutput
LEFTMOST = STATS_min; RIGHT = RIGHT > STATS_max ? RIGHT : STATS_max
SPREAD = RIGHT - LEFTMOST
LEFTMOST = LEFTMOST - 0.04*SPREAD; RIGHT = RIGHT + 0.04*SPREAD
WIDTH = 640.0
PANEL = 262.0
TREE = PANEL*TOPMOST*1.04/(RIGHT - LEFTMOST); TREE = TREE > 112 ? 112.0 : TREE < 120 ? 120.0 : TREE
HEIGHT = TREE + 302.0
load HERE.'start.gp'
set multiplot
unset key; unset grid
set border 3 lw 0.6
array TITLE[2] = [sprintf(L('OPEN_AT'), three(SPEED, 'm/s')), sprintf(L('OWN_LAW'), LAW)]
array A0[2] = ["open0_m", "own0_m"]; array U0[2] = ["open_up0_m", "own_up0_m"]
array A1[2] = ["open1_m", "own1_m"]; array U1[2] = ["open_up1_m", "own_up1_m"]
thick(r) = 0.3 + 14*r
# same scale on both axes, also where the tree is too slender or too wide for its panel
SCALE = TREE/(TOPMOST*1.04); HALF = 0.5*PANEL/SCALE; MIDDLE = 0.5*(LEFTMOST + RIGHT)
set xrange [MIDDLE-HALF:MIDDLE+HALF]; set yrange [0:TOPMOST*1.04]
do for [i=1:2] {
    x0 = 50.0 + (i - 1)*(PANEL + 48.0)
    set lmargin at screen x0/WIDTH; set rmargin at screen (x0 + PANEL)/WIDTH
    set tmargin at screen 1 - 30.0/HEIGHT; set bmargin at screen 1 - (30.0 + TREE)/HEIGHT
    set title TITLE[i] offset 0,-0.6
    set xlabel L('ALONG_RIGHT') offset 0,0.4
    if (i == 1) { set ylabel L('HEIGHT_M') offset 1,0 } else { set ylabel "" }
    plot ROWTABLE using (PER_M*column("along0_m")):(PER_M*column("up0_m")):(PER_M*column("along1_m")-PER_M*column("along0_m")):(PER_M*column("up1_m")-PER_M*column("up0_m")) with vectors nohead dt 1 lc rgb '#c8c8c8' lw 0.6, \
         ROWTABLE using (PER_M*column(A0[i])):(PER_M*column(U0[i])):(PER_M*(column(A1[i])-column(A0[i]))):(PER_M*(column(U1[i])-column(U0[i]))) with vectors nohead dt 1 lc rgb (i == 1 ? '#D55E00' : '#0072B2') lw 0.9
}
set grid lw 0.5 lt 1 lc rgb '#e3e3e3' dt 1
set xlabel L('DEPTH') offset 0,0.4; set ylabel ""
set xrange [0:1]; set yrange [0:*]
Y0 = TREE + 112.0
array WHAT[2] = [L('WIND_ENDS'), L('SWING_ENDS')]
array PER_END[2] = [PER_MS, PER_M]
array OPENC[2] = ["wind_open_ms", "swing_open_m"]; array OWNC[2] = ["wind_own_ms", "swing_own_m"]
do for [i=1:2] {
    x0 = 50.0 + (i - 1)*(PANEL + 48.0)
    set lmargin at screen x0/WIDTH; set rmargin at screen (x0 + PANEL)/WIDTH
    set tmargin at screen 1 - Y0/HEIGHT; set bmargin at screen 1 - (Y0 + 110.0)/HEIGHT
    set title WHAT[i] offset 0,-0.6
    plot TIPTABLE using (column("depth_share")):(PER_END[i]*column(OPENC[i])) with points pt 6 ps 0.5 lc rgb '#D55E00', \
         TIPTABLE using (column("depth_share")):(PER_END[i]*column(OWNC[i])) with points pt 7 ps 0.35 lc rgb '#0072B2'
}
KEY = 24.0
load HERE.'strip.gp'
unset title; set yrange [0:1]; set key samplen 2 maxrows 1 width 0
plot NaN with points pt 6 ps 0.7 lc rgb '#D55E00' title L('OPEN'), NaN with points pt 7 ps 0.6 lc rgb '#0072B2' title L('OWN'), NaN with lines dt 1 lc rgb '#c8c8c8' lw 1.5 title L('REST')
unset multiplot
set output
