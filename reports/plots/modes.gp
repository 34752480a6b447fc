# SPDX-License-Identifier: GPL-3.0-or-later
# The sway of a whole tree and its first modes: at rest in grey, moved in black, by at most a tenth of its height; each seen from where it
# is widest: from the side of the wind, or along it.
#   gnuplot -c modes.gp FOLDER [FILE [LANGUAGE [RUN]]]
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'modes.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'
SHOWN = ARGC > 3 ? int(ARG4) : 1
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
MODES = int(number(sprintf('MODES_%d', SHOWN), 0)); TALL = PER_M*number('HEIGHT', 0)
SHAPES = DIR.'/tables/mode_shapes.csv'
mine(k) = column("run") == SHOWN && column("mode") == k
side(k) = (MODE_D = k > 0 ? text_of(sprintf('DIRECTION_%d', SHOWN), k) : '', MODE_D eq 'across' || (MODE_D ne 'along' && number(sprintf('ACROSS_%d', SHOWN), k) > 0))
x(k, end) = PER_M*(side(k) ? column(sprintf('across%d_m', end)) : column(sprintf('along%d_m', end)))
z(end) = PER_M*column(sprintf('z%d_m', end))
GROW = 0.1*TALL
mx(k, end) = x(k, end) + GROW*(side(k) ? column(sprintf('move_across%d', end)) : column(sprintf('move_along%d', end)))
mz(end) = z(end) + GROW*column(sprintf('move_up%d', end))

# one true scale for all, wide enough for each tree from both sides
low = 0.0; high = 0.0; top = TALL; floor = 0.0
do for [k=0:MODES] {
    stats SHAPES using (pick(mine(k), x(k, 1))):(pick(mine(k), z(1))) name 'S' nooutput
    low = S_min_x < low ? S_min_x : low; high = S_max_x > high ? S_max_x : high
    top = S_max_y > top ? S_max_y : top; floor = S_min_y < floor ? S_min_y : floor
}
low = low - 1.15*GROW; high = high + 1.15*GROW; top = top + 0.6*GROW; floor = floor < 0 ? floor - 0.3*GROW : 0
WIDTH = 640.0; LEFT = 50.0; GAP = 20.0; TITLE = 34.0; UNDER = 46.0; KEY = 34.0
columns = MODES < 2 ? 2 : MODES < 6 ? 3 : 4
rows = (MODES + columns)/columns
w = (WIDTH - LEFT - 12)/columns - GAP
scale = w/(high - low)
most = rows > 1 ? 110.0 : 300.0
scale = scale*(top - floor) > most ? most/(top - floor) : scale
# a slender tree gets room for three figures on its axis
if (scale*(high - low) < 96) { middle = 0.5*(low + high); low = middle - 48/scale; high = middle + 48/scale }
w = scale*(high - low); h = scale*(top - floor)
room = (WIDTH - LEFT - 12)/columns
HEIGHT = rows*(h + TITLE + UNDER) + KEY
load HERE.'start.gp'
set multiplot
set key off
step = 1000.0
do for [s in "500 200 100 50 20 10 5 2 1 0.5 0.2 0.1 0.05 0.02 0.01"] { step = real(s)*scale >= 30 ? real(s) : step }
set xtics step; set ytics step
set xrange [low:high]; set yrange [floor:top]
do for [k=0:MODES] {
    c = k%columns; r = k/columns
    x0 = LEFT + c*room + 0.5*(room - w); y1 = HEIGHT - r*(h + TITLE + UNDER) - TITLE
    set lmargin at screen x0/WIDTH; set rmargin at screen (x0 + w)/WIDTH
    set tmargin at screen y1/HEIGHT; set bmargin at screen (y1 - h)/HEIGHT
    set title k == 0 ? sprintf(L('MODE_TREE'), text_of(sprintf('TREE_%d', SHOWN), 0)) : sprintf(L('MODE_TITLE'), k, text_of(sprintf('FREQUENCY_%d', SHOWN), k), L('MODE_'.text_of(sprintf('DIRECTION_%d', SHOWN), k))) font ',10' offset 0,-0.5
    set xlabel (side(k) ? L('MODE_ACROSS') : L('ALONG')) offset 0,0.4
    if (c == 0) { set ylabel L('HEIGHT') offset 0.8,0; set format y '%g' } else { unset ylabel; set format y '' }
    plot SHAPES using (pick(mine(k), x(k, 0))):(z(0)):(x(k, 1) - x(k, 0)):(z(1) - z(0)) with vectors nohead lw 0.6 dt 1 lc rgb '#b0b0b0', \
         SHAPES using (pick(mine(k), mx(k, 0))):(mz(0)):(mx(k, 1) - mx(k, 0)):(mz(1) - mz(0)) with vectors nohead lw 0.6 dt 1 lc rgb '#000000'
}
load HERE.'strip.gp'
set key on
plot 2 with lines, keyentry with lines lw 1.4 dt 1 lc rgb '#b0b0b0' title L('MODE_REST'), \
     keyentry with lines lw 1.4 dt 1 lc rgb '#000000' title L('MODE_MOVED')
unset multiplot
set output
