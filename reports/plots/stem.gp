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

# Both ends of every segment of the stems, base first: where the stem is stepped, the larger stress may be at either.
TABLE = SEGMENTS
load HERE.'rows.gp'
stem(i, k) = at(i, WIND[k]) && column("level") == 0
array ON_STEM[trees]
points = 0
do for [i=1:trees] {
    ON_STEM[i] = 0
    if (words(SOLVED[i])) {
        stats SEGMENTS every ::row_first(i, 1)::row_last(i, 1) using (stem(i, nth(SOLVED[i], 1)) ? (ON_STEM[i] = ON_STEM[i] + 1) : 0) name 'S' nooutput
    }
    points = points + 2*ON_STEM[i]*words(SOLVED[i])
}
array END_HEIGHT[points + 1]; array END_MOMENT[points + 1]; array END_STRESS[points + 1]
array BEFORE[trees*winds + 1]; do for [p=1:|BEFORE|] { BEFORE[p] = 0 }
points = 0; moment = 0.0; stress = 0.0; top = 0.0
keep_end(z, bending, fibre) = (points = points + 1, END_HEIGHT[points] = z, END_MOMENT[points] = bending, END_STRESS[points] = fibre, \
    moment = greater(bending/1e3, moment), stress = greater(fibre, stress))
keep_ends(is) = is ? (keep_end(column("height0_m"), column("bending0_Nm"), column("stress0_MPa")), \
    keep_end(column("height1_m"), column("bending1_Nm"), column("stress1_MPa"))) : 0
do for [i=1:trees] {
    top = HEIGHT_M[i] > top ? HEIGHT_M[i] : top
    do for [n=1:words(SOLVED[i])] {
        BEFORE[place(i, n)] = points
        if (ON_STEM[i]) { stats SEGMENTS every ::row_first(i, n)::row_last(i, n) using (keep_ends(stem(i, nth(SOLVED[i], n)))) name 'S' nooutput }
    }
}
first_end(i, n) = BEFORE[place(i, n)] + 1
last_end(i, n) = first_end(i, n) + 2*ON_STEM[i] - 1
load HERE.'start.gp'
set multiplot
unset datafile columnheaders   # from here on arrays are drawn, of which none is a heading
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
        unit = panel ? PER[STRESS] : 1e-3*PER[MOMENT]
        most = panel ? PER[STRESS]*stress : PER[MOMENT]*moment
        set xrange [0:(most > 0 ? 1.05*most : 1)]
        # figures of the axis at least 38 pixels apart
        step = 0.0
        do for [d=8:-4:-1] { do for [m in "5 2 1"] { s = real(m)*10.0**d; step = (most <= 0 || s*w/(1.05*most) >= 38) ? s : step } }
        if (most > 0) { set xtics step } else { set xtics autofreq }
        plot for [n=1:words(SOLVED[i])] [first_end(i, n):last_end(i, n):1] '+' using (unit*(panel ? END_STRESS[int($1)] : END_MOMENT[int($1)])):(PER[LENGTH]*END_HEIGHT[int($1)]) with lines lt nth(SOLVED[i], n), \
             [0:1:1] -1 with lines   # below the picture: a tree without answers still gets its axes
    }
}
load HERE.'strip.gp'
plot 2 with lines, for [k=1:winds] keyentry with lines lt k title speed(WIND[k])
unset multiplot
set output
