# SPDX-License-Identifier: GPL-3.0-or-later
# The records: which rows took part; for free sway the fitted curve.
#   gnuplot -c fit_records.gp FOLDER [FILE [LANGUAGE]]
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'fit_records.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
TESTS = int(number('TESTS', 0)); RECORDED = int(number('RECORDED', 0))
RECORDS = DIR.'/tables/records.csv'
SHOWN = RECORDED ? (TESTS > 8 ? 8 : TESTS) : 0
ROWS = SHOWN ? (SHOWN + 1)/2 : 1
WIDTH = 640.0; STEP = SHOWN > 1 ? 220.0 : 196.0; HEIGHT = STEP*ROWS + 10
SPAN = SHOWN == 1 ? 560.0 : 236.0
of_test(k) = column("test") == k
load HERE.'start.gp'
set multiplot
unset key
if (!SHOWN) { unset border; unset tics; set yrange [0:1]; set label 1 L('NO_RECORDS') at graph 0.5,0.5 center; plot [0:1] -1 }
do for [k=1:SHOWN] {
    i = k - 1; x0 = (i%2) ? 392.0 : 68.0; y1 = HEIGHT - 28.0 - STEP*(i/2)
    set lmargin at screen x0/WIDTH; set rmargin at screen (x0 + SPAN)/WIDTH
    set tmargin at screen y1/HEIGHT; set bmargin at screen (y1 - STEP + 80)/HEIGHT
    set title short(text_of('TEST', k), SPAN + 60) offset 0,-0.6
    set xlabel L('TIME'); set ylabel with_unit(L(text_of('TEST_LOAD', k)), text_of('TEST_UNIT', k)) offset 1,0
    set xrange [*:*]; set yrange [*:*]; PER_Y = per(text_of('TEST_UNIT', k))
    if (number('SWAY', k) == 1) {
        unset ylabel; set title short(text_of('TEST', k), 0.6*SPAN).': '.with_unit(L(text_of('TEST_LOAD', k)), text_of('TEST_UNIT', k))
        plot RECORDS using (pick(of_test(k), column("time_s"))):(PER_Y*column("load")) with points lt 1 pt 7 ps 0.3, '' using (pick(of_test(k), column("time_s"))):(PER_Y*column("fitted")) with lines lt 2 dt 1
    } else {
        plot RECORDS using (pick(of_test(k), column("time_s"))):(PER_Y*column("load")) with lines lt 1 lc rgb '#999999' lw 0.8, \
             '' using (pick(of_test(k) && column("used") > 0, column("time_s"))):(PER_Y*column("load")) with points lt 2 pt 7 ps 0.3
    }
}
unset multiplot
set output
