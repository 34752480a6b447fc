# SPDX-License-Identifier: GPL-3.0-or-later
# A tree from the front (seen along +y, wind from the left) and from the side (seen along -x), coloured by level,
# on one true scale; its parameters beside it.
#   gnuplot -c tree.gp FOLDER [FILE [LANGUAGE]]
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'tree.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
FACTS = 'tree'
load HERE.'style.gp'
LEVELS = int(number('LEVELS', 0)); P_ROWS = int(number('P_ROWS', 0))
X_LOW = PER_M*number('X_LOW', 0); X_HIGH = PER_M*number('X_HIGH', 0); Y_LOW = PER_M*number('Y_LOW', 0); Y_HIGH = PER_M*number('Y_HIGH', 0)
Z_LOW = PER_M*number('Z_LOW', 0); Z_HIGH = PER_M*number('Z_HIGH', 0)
DATA = DIR.'/plots/tree.dat'
set datafile separator whitespace
set datafile nocolumnheaders
array COLOUR[8] = ['#5C4033', '#0072B2', '#D55E00', '#009E73', '#CC79A7', '#E69F00', '#56B4E9', '#000000']
colour(l) = l > 8 ? '#999999' : COLOUR[l]

# a margin, and a common floor; a slender tree still gets a readable view
floor = Z_LOW < 0 ? Z_LOW : 0
tall = Z_HIGH - floor
margin = 0.03*tall
wide(low, high) = high - low > 0.12*tall ? high - low : 0.12*tall
fw = wide(X_LOW, X_HIGH) + 2*margin; sw = wide(Y_LOW, Y_HIGH) + 2*margin
WIDTH = 640.0; LEFT = 52.0; GAP = 26.0; TABLE = 252.0; TITLE = 26.0; UNDER = 52.0; LINE = 15.5
room = WIDTH - LEFT - GAP - TABLE
scale = room/(fw + sw)
scale = scale*(tall + margin) > 260 ? 260/(tall + margin) : scale
h = scale*(tall + margin)
least = LINE*(P_ROWS + LEVELS + 3)
h = h < 160 ? 160 : h
HEIGHT = TITLE + (h > least ? h : least) + UNDER
load HERE.'start.gp'
set multiplot
set key off
top = HEIGHT - TITLE
step = 1000.0
do for [s in "500 200 100 50 20 10 5 2 1 0.5 0.2 0.1 0.05 0.02 0.01"] { step = real(s)*scale >= 30 ? real(s) : step }
set xtics step; set ytics step
set style fill solid 1.0 border
set yrange [floor:floor + h/scale]
x0 = LEFT + 0.5*(room - scale*(fw + sw))
do for [side=0:1] {
    low = side ? Y_LOW : X_LOW; high = side ? Y_HIGH : X_HIGH; w = side ? sw : fw
    middle = 0.5*(low + high)
    set xrange [middle - 0.5*w:middle + 0.5*w]
    set lmargin at screen x0/WIDTH; set rmargin at screen (x0 + scale*w)/WIDTH
    set tmargin at screen top/HEIGHT; set bmargin at screen (top - h)/HEIGHT
    set title (side ? L('SIDE') : L('FRONT')) offset 0,-0.6
    set xlabel (side ? L('TREE_Y') : L('TREE_X')) offset 0,0.4
    if (side) { unset ylabel; set format y '' } else { set ylabel L('TREE_HEIGHT') offset 0.8,0; set format y '%g' }
    plot for [l=LEVELS:1:-1] DATA index 4*(l-1)+2*side+1 using (PER_M*$1):(PER_M*$2) with lines lw 0.5 dt 1 lc rgb colour(l), \
         for [l=LEVELS:1:-1] DATA index 4*(l-1)+2*side using (PER_M*$1):(PER_M*$2) with filledcurves closed lw 0.3 lc rgb colour(l)
    x0 = x0 + scale*w + GAP
}
# the table: names left, values right of them; levels in their colour
unset border; unset tics; unset grid; unset title; unset xlabel; unset ylabel
set lmargin at screen 0; set rmargin at screen 1; set bmargin at screen 0; set tmargin at screen 1
set xrange [0:WIDTH]; set yrange [0:HEIGHT]
left = WIDTH - TABLE + 12
do for [k=1:P_ROWS] {
    y = top - LINE*(k - 0.5)
    name = L(text_of('P_NAME', k)); said = text_of('P_WORD', k)
    said = strlen(said) ? L(said) : short(text_of('P_VALUE', k), 180)
    set label k name at left, y font ',10' textcolor rgb '#606060'
    set label 100 + k said at left + 94, y font ',10'
}
y = top - LINE*(P_ROWS + 1)
set label 200 L('TREE_LEVEL') at left, y font ',10' textcolor rgb '#606060'
set label 201 L('TREE_AXES') at left + 116, y right font ',10' textcolor rgb '#606060'
set label 202 L('TREE_LENGTH') at left + 186, y right font ',10' textcolor rgb '#606060'
set label 203 L('TREE_DIAMETER') at left + 236, y right font ',10' textcolor rgb '#606060'
do for [l=1:LEVELS] {
    y = top - LINE*(P_ROWS + 1 + l)
    name = short(L(text_of('LEVEL', l)), 130); axes = text_of('L_COUNT', l); long = text_of('L_LENGTH', l); wide = text_of('L_DIAMETER', l)
    set label 300 + l name at left, y font ',9.5' textcolor rgb colour(l)
    set label 400 + l axes at left + 116, y right font ',9.5'
    set label 500 + l long at left + 186, y right font ',9.5'
    set label 600 + l wide at left + 236, y right font ',9.5'
}
plot -1
unset multiplot
set output
