# SPDX-License-Identifier: GPL-3.0-or-later
# The first tree in its strongest wind with an answer: its stem coloured by the share of the bending strength that is used,
# beside the unloaded one, and the wind load by height.
#   gnuplot -c front.gp FOLDER [FILE [LANGUAGE]]
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'front.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
load HERE.'report_facts.gp'
along(x, y) = column(x)*cos(AZIMUTH[1]) + column(y)*sin(AZIMUTH[1])
n = words(SOLVED[1]); u = n ? WIND[nth(SOLVED[1], n)] : NaN
stem(is) = is && column("axis") == 1

# loads by height, in bins; use of the strength along the stem, of a segment the larger of its ends
TABLE = SEGMENTS
load HERE.'rows.gp'
BINS = 9
array LOAD[BINS]; do for [b=1:BINS] { LOAD[b] = 0.0 }
MOST = 0.0
array USE[ROWS[1] + 1]; do for [k=1:|USE|] { USE[k] = NaN }
bin(z) = (BIN_B = 1 + int(BINS*z/HEIGHT_M[1]), BIN_B < 1 ? 1 : BIN_B > BINS ? BINS : BIN_B)
used(s) = s > 0 ? 100.0/s : NaN
keep(is) = is ? (LOAD_B = bin(0.5*(column("height0_m") + column("height1_m"))), LOAD[LOAD_B] = LOAD[LOAD_B] + column("drag_N"), \
    column("level") == 0 ? (KEEP_U = greater(used(column("safety1")), used(column("safety0"))), USE[int(column("segment"))] = KEEP_U, MOST = greater(KEEP_U, MOST)) : 0) : 0
if (n) { stats SEGMENTS every ::row_first(1, n)::row_last(1, n) using (keep(at(1, u))) name 'S' nooutput }
FULL = 0.0; do for [b=1:BINS] { FULL = greater(FULL, LOAD[b]) }

do for [p=1:|FIRST|] { FIRST[p] = -1; LAST[p] = 0 }
TABLE = SHAPE
load HERE.'rows.gp'
low = 0.0; high = 0.0; floor = 0.0; top = HEIGHT_M[1]
if (n) {
    stats SHAPE every ::row_first(1, n)::row_last(1, n) using (pick(at(1, u), along("loaded_x_m", "loaded_y_m"))):"loaded_z_m" name 'S' nooutput
    low = S_min_x < low ? S_min_x : low; high = S_max_x > high ? S_max_x : high; floor = S_min_y < floor ? S_min_y : floor
}
top = 1.05*top
CROWN_B = number('CROWN_BREADTH', 1); CROWN_C = number('CROWN_CENTRE', 1); CROWN_H = number('CROWN_HEIGHT', 1)
crowned = CROWN_B > 0 && CROWN_H > 0
low = crowned && -0.5*CROWN_B < low ? -0.5*CROWN_B : low
high = crowned && 0.5*CROWN_B > high ? 0.5*CROWN_B : high
reach = 0.3*top                                    # room of the arrows
low = low - reach - 0.04*top; high = high + 0.06*top
WIDTH = 340.0; LEFT = 52.0; RIGHT = 12.0; UNDER = 48.0; BAR = MOST > 0 ? 66.0 : 0.0; TITLE = 10.0
scale = (WIDTH - LEFT - RIGHT)/(high - low)
scale = scale*(top - floor) > 215 ? 215/(top - floor) : scale
h = scale*(top - floor); w = WIDTH - LEFT - RIGHT
spare = w/scale - (high - low); low = low - 0.5*spare; high = high + 0.5*spare
HEIGHT = h + TITLE + UNDER + BAR
load HERE.'start.gp'
set key off
set xrange [low:high]; set yrange [floor:top]
step = 1000.0
do for [s in "500 200 100 50 20 10 5 2 1 0.5 0.2 0.1 0.05 0.02 0.01"] { step = lengths(real(s))*scale >= 32 ? real(s) : step }
if (turned) {
    set xtics ('0' 0); set ytics ('0' 0)
    do for [k=-100:100] { set xtics add (tic(k*step) lengths(k*step)); set ytics add (tic(k*step) lengths(k*step)) }
} else { set xtics step; set ytics step }
set lmargin at screen LEFT/WIDTH; set rmargin at screen (LEFT + w)/WIDTH
set tmargin at screen (HEIGHT - TITLE)/HEIGHT; set bmargin at screen (HEIGHT - TITLE - h)/HEIGHT
set xlabel L('ALONG') offset 0,0.4; set ylabel L('HEIGHT') offset 0.8,0
# from blue over grey to dark red-brown, seen alike by the colour-blind
set palette defined (0 '#56B4E9', 25 '#0072B2', 50 '#E69F00', 75 '#D55E00', 100 '#5a1a00')
set cbrange [0:100]; set cbtics 25 scale 0.4
set cblabel L('USED') offset 0,0.8
if (MOST > 0) { set colorbox horizontal user origin LEFT/WIDTH + 0.06, 48.0/HEIGHT size w/WIDTH - 0.12, 9.0/HEIGHT } else { unset colorbox }
arrow(b) = FULL > 0 ? reach*0.92*LOAD[b]/FULL : 0
from = low + 0.02*top
if (n && FULL > 0) {
    do for [b=1:BINS] {
        z = top/1.05*(b - 0.5)/BINS
        if (arrow(b) > 0.02*reach) { set arrow b from from, z to from + arrow(b), z head filled size first 0.018*top, 20 lw 1.4 lc rgb '#0072B2' front }
    }
    set label 1 (turned ? put(L('WIND_LOAD'), '%s kN', said(FORCE, FULL/1e3).' '.UNIT[FORCE]) : sprintf(L('WIND_LOAD'), sprintf(FULL < 1e3 ? '%.2g' : FULL < 1e5 ? '%.1f' : '%.0f', FULL/1e3))) at from, top*0.985 font ',10.5' textcolor rgb '#0072B2'
}
px = 0.0; py = 0.0; ox = 0.0; oy = 0.0
few = ROWS[1] <= 5000
from_last(is, x, y) = (ox = px, oy = py, px = x, py = y, is && column("segment") > 0 ? ox : NaN)
use(k) = k >= 1 && k <= |USE| ? USE[int(k)] : NaN
set samples 120
set parametric; set trange [0:2*pi]
plot for [k=1:(crowned ? 1 : 0)] 0.5*CROWN_B*cos(t), CROWN_C + 0.5*CROWN_H*sin(t) with lines lw 0.8 dt (2,3) lc rgb '#5f8f5f', \
     for [k=1:(n && few ? 1 : 0)] SHAPE every ::row_first(1, n)::row_last(1, n) using (from_last(at(1, u) && column("axis") > 1, along("loaded_x_m", "loaded_y_m"), column("loaded_z_m"))):(oy):(px - ox):(py - oy) with vectors nohead lw 0.4 dt 1 lc rgb '#909090', \
     for [k=1:(n ? 1 : 0)] SHAPE every ::row_first(1, n)::row_last(1, n) using (pick(stem(at(1, u)), along("x_m", "y_m"))):"z_m" with lines lw 1.2 dt (10,6) lc rgb '#707070', \
     for [k=1:(n ? 1 : 0)] SHAPE every ::row_first(1, n)::row_last(1, n) using (pick(stem(at(1, u)), along("loaded_x_m", "loaded_y_m"))):"loaded_z_m" with lines lw 5.5 dt 1 lc rgb '#b8b8b8', \
     for [k=1:(n && MOST > 0 ? 1 : 0)] SHAPE every ::row_first(1, n)::row_last(1, n) using (from_last(stem(at(1, u)) && use(column("segment")) >= 0, along("loaded_x_m", "loaded_y_m"), column("loaded_z_m"))):(oy):(px - ox):(py - oy):(use(column("segment"))) with vectors nohead lw 5.5 dt 1 lc palette, \
     2*top, 2*top with lines   # above the picture: a tree without answers still gets its axes
set output
