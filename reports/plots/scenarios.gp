# SPDX-License-Identifier: GPL-3.0-or-later
# The tree as it stands and with something changed, a line each: its least safeties.
#   gnuplot -c scenarios.gp FOLDER [FILE [LANGUAGE]]
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'scenarios.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
BESIDE = int(number('BESIDE', 0)); REQUIRED = number('REQUIRED', 0); KINDS = 3
array KIND[3] = ['BESIDE_STEM', 'BESIDE_ROOT', 'BESIDE_BRANCHES']
array VALUE[3*BESIDE + 1]; array NAME[BESIDE + 1]; array ANY[3]
LEAST = 1.0; MOST = 1.0
do for [k=1:3] { ANY[k] = 0 }
do for [i=1:BESIDE] {
    NAME[i] = text_of('BESIDE_NAME', i)
    do for [k=1:3] {
        v = number(KIND[k], i); VALUE[3*(i - 1) + k] = v
        if (v == v && v > 0) { ANY[k] = 1; LEAST = v < LEAST ? v : LEAST; MOST = v > MOST ? v : MOST }
    }
}
if (REQUIRED == REQUIRED) { MOST = REQUIRED > MOST ? REQUIRED : MOST }
LEAST = LEAST < 0.05 ? 0.05 : LEAST; MOST = MOST > 20 ? 20 : MOST
SPAN = 270.0; NAMES = 0.8*(SPAN - 10)   # letters of a document are wider than those of a page
WIDTH = 640.0; STEP = 34.0; HEIGHT = 92.0 + STEP*BESIDE
load HERE.'start.gp'
set lmargin at screen SPAN/WIDTH; set rmargin at screen 1 - 16.0/WIDTH
set tmargin at screen 1 - 34.0/HEIGHT; set bmargin at screen 58.0/HEIGHT
set logscale x 10; set xrange [LEAST/1.3:MOST*1.3]; set yrange [BESIDE + 0.5:0.5]
set xtics add ("0.05" 0.05, "0.1" 0.1, "0.2" 0.2, "0.5" 0.5, "1" 1, "2" 2, "5" 5, "10" 10, "20" 20)
unset ytics
# a label may be broken at every part of a change
apart(s) = (BESIDE_S = '', sum [BESIDE_I=1:strlen(s)] (BESIDE_S = BESIDE_S.(s[BESIDE_I:BESIDE_I] eq '+' ? ' + ' : s[BESIDE_I:BESIDE_I]), 0), BESIDE_S)
do for [i=1:BESIDE] {
    name = two_lines(apart(NAME[i]), NAMES)
    set label i name at screen (SPAN - 10)/WIDTH, first i right offset 0,(strstrt(name, "\n") ? 0.4 : 0) textcolor rgb '#202020'
}
set xlabel L('SAFETY')
set arrow 1 from 1, graph 0 to 1, graph 1 nohead lw 1 lc rgb '#404040'
if (REQUIRED == REQUIRED) { set arrow 2 from REQUIRED, graph 0 to REQUIRED, graph 1 nohead lw 1 dt (8,6) lc rgb '#404040' }
set key at screen 0.99, screen 0.995 top right Left reverse maxrows 1 samplen 1
within(v) = v == v && v > 0 ? (v < LEAST ? LEAST : v > MOST ? MOST : v) : NaN
shown(k) = ANY[k] ? L(KIND[k]) : ''
set samples BESIDE + 1 # the last row is drawn twice
row(n) = int(n) + 1 > BESIDE ? BESIDE : int(n) + 1
plot for [k=1:3] '+' using (within(VALUE[3*(row($0) - 1) + k])):(row($0)) with points lt k ps 1.1 title shown(k)
set output
