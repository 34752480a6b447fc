# SPDX-License-Identifier: GPL-3.0-or-later
# Bending moment and outer-fibre stress along the stem: one column a tree, one line a wind speed.
#   gnuplot -c stem.gp FOLDER [FILE [LANGUAGE]]
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'stem.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
load HERE.'report_facts.gp'
# of one tree moment and stress side by side, of more the moment above
columns = trees == 1 ? 2 : trees < 5 ? trees : 3
below = trees > 1
blocks = (trees + columns - 1)/columns
LEFT = 58.0; GAP = 24.0; TITLE = 24.0; UNDER = 54.0; KEY = 30.0
w = (640.0 - LEFT - 14 - GAP*(columns-1))/columns
h = trees == 1 ? 180.0 : blocks == 1 ? 140.0 : 110.0
WIDTH = 640.0; HEIGHT = blocks*(TITLE + (1 + below)*(h + UNDER)) + KEY

moment = 0.0; stress = 0.0; top = 0.0
array TIP[trees]
TABLE = SEGMENTS
load HERE.'rows.gp'
stem(i, k) = at(i, WIND[k]) && column("level") == 0
most_of(is) = is ? (tip_row = greater(column("segment"), tip_row), moment = greater(column("bending0_Nm")/1e3, moment), \
    stress = greater(column("stress0_MPa"), stress)) : 0
do for [i=1:trees] {
    top = HEIGHT_M[i] > top ? HEIGHT_M[i] : top
    do for [n=1:words(SOLVED[i])] {
        k = nth(SOLVED[i], n)
        tip_row = 0
        stats SEGMENTS every ::row_first(i, n)::row_last(i, n) using (most_of(stem(i, k))) name 'S' nooutput
        TIP[i] = tip_row
    }
}
last(i, k) = stem(i, k) && column("segment") == TIP[i]
load HERE.'start.gp'
set multiplot
set yrange [0:1.03*PER[LENGTH]*top]; set ytics autofreq
do for [i=1:trees] {
    b = below ? (i-1)/columns : 0
    do for [panel=0:1] {
        c = below ? (i-1)%columns : panel
        x0 = LEFT + c*(w + GAP)
        set lmargin at screen x0/WIDTH; set rmargin at screen (x0 + w)/WIDTH
        if (c == 0) { set ylabel L('HEIGHT') offset 0.8,0; set format y '%g' } else { unset ylabel; set format y '' }
        y1 = HEIGHT - b*(TITLE + 2*(h + UNDER)) - TITLE - below*panel*(h + UNDER)
        set tmargin at screen y1/HEIGHT; set bmargin at screen (y1 - h)/HEIGHT
        if (panel) { unset title } else { set title short(NAME[i], w + GAP) offset 0,-0.5 }
        set xlabel (panel ? L('STRESS') : L('MOMENT')) offset 0,0.4
        A = panel ? "stress0_MPa" : "bending0_Nm"; B = panel ? "stress1_MPa" : "bending1_Nm"
        unit = panel ? PER[STRESS] : 1e-3*PER[MOMENT]
        most = panel ? PER[STRESS]*stress : PER[MOMENT]*moment
        set xrange [0:(most > 0 ? 1.05*most : 1)]
        # figures of the axis at least 38 pixels apart
        step = 0.0
        do for [d=8:-4:-1] { do for [m in "5 2 1"] { s = real(m)*10.0**d; step = (most <= 0 || s*w/(1.05*most) >= 38) ? s : step } }
        if (most > 0) { set xtics step } else { set xtics autofreq }
        # base ends of all rows, then the last row to its tip
        plot for [n=1:words(SOLVED[i])] SEGMENTS every ::row_first(i, n)::row_last(i, n) using (pick(stem(i, nth(SOLVED[i], n)), unit*column(A))):(PER[LENGTH]*column("height0_m")) with lines lt nth(SOLVED[i], n), \
             for [n=1:words(SOLVED[i])] SEGMENTS every ::row_first(i, n)::row_last(i, n) using (pick(last(i, nth(SOLVED[i], n)), unit*column(A))):(PER[LENGTH]*column("height0_m")):(unit*(column(B)-column(A))):(PER[LENGTH]*(column("height1_m")-column("height0_m"))) with vectors nohead lt nth(SOLVED[i], n), \
             -1 with lines   # below the picture: a tree without answers still gets its axes
    }
}
load HERE.'strip.gp'
plot 2 with lines, for [k=1:winds] keyentry with lines lt k title speed(WIND[k])
unset multiplot
set output
