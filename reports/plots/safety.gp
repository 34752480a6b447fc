# SPDX-License-Identifier: GPL-3.0-or-later
# Safety of the tree against wind speed, and the wind at which it reaches 1; thin and dotted, the least safety against
# breakage of any part. Results that do not know the loss of the tree have the latter alone. Lines end where the tree has no
# equilibrium.
#   gnuplot -c safety.gp FOLDER [FILE [LANGUAGE]]
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'safety.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
load HERE.'report_facts.gp'
KEY = 12.0 + 18*KEY_ROWS
WIDTH = 640.0; ABOVE = 32.0; HEIGHT = 264.0 + KEY
load HERE.'start.gp'
safety_of(n) = LOSS_KNOWN[nth(STRONG, n)] ? "tree_safety" : "least_safety"
# a line passes over an empty field as over a row that is not there, and is broken by what is not a number
answer(name) = pick(strcol("status") eq 'ok', column(name))
set multiplot
from = 0.5
most = 10.0
do for [n=1:words(STRONG)] {
    stats SWEEP using (pick(of(nth(STRONG, n)) && column("wind_m_s") >= 0.1*SPEED_MAX, column(safety_of(n)))) name 'S' nooutput
    most = S_max > most ? S_max : most
    stats SWEEP using (pick(of(nth(STRONG, n)) && column("wind_m_s") <= SPEED_MAX, column(safety_of(n)))) name 'S' nooutput
    from = S_min < from ? S_min : from
    undefine S_*   # of a tree whose root alone is known there is no such number
    stats SWEEP using (pick(of(nth(STRONG, n)) && column("wind_m_s") <= SPEED_MAX, column("least_safety"))) name 'S' nooutput
    if (exists('S_min')) { from = S_min > 0 && S_min < from ? S_min : from }
}
from = from < 0.1 ? 0.1 : from
set xrange [0:PER[SPEED]*SPEED_MAX]; set yrange [from:1.1*most]; set logscale y 10
set ytics add ("0.1" 0.1, "0.2" 0.2, "0.5" 0.5, "1" 1, "2" 2, "5" 5, "20" 20, "50" 50)
set format y '%g'
set xlabel sprintf(L('WIND'), typed(number('REFERENCE', 0), 'm')); set ylabel L('SAFETY') offset 1,0
set lmargin at screen 60.0/WIDTH; set rmargin at screen 1 - 16.0/WIDTH
set tmargin at screen 1 - ABOVE/HEIGHT; set bmargin at screen (52.0 + KEY)/HEIGHT
# Critical speeds: a line up to the figure, which stands above the plot, where no curve passes; close neighbours stand above one
# another.
do for [n=1:words(STRONG)] {
    i = nth(STRONG, n); u = CRITICAL[i]
    if (u == u && u <= SPEED_MAX) {
        near = 0
        do for [m=1:n-1] { near = near + (abs(CRITICAL[nth(STRONG, m)] - u) < 0.1*SPEED_MAX ? 1 : 0) }
        set arrow from PER[SPEED]*u, 1 to PER[SPEED]*u, 1.1*most nohead lt i lw 1
        set label '' at PER[SPEED]*u, 1 point pt 6 ps 1.1 lw 1.6 lc rgb '#202020'
        name = speed(real(sprintf('%.1f', u)))
        set label name at PER[SPEED]*u, graph 1 center offset 0,0.6 + near%2 textcolor rgb '#202020'
    }
}
if (words(STRONG) == 0) {
    plot 1 with lines lw 1 dt 1 lc rgb '#404040'   # no strength is known: the frame alone
} else {
    plot 1 with lines lw 1 dt 1 lc rgb '#404040', \
         for [n=1:words(STRONG)] SWEEP using (pick(of(nth(STRONG, n)) && LOSS_KNOWN[nth(STRONG, n)], PER[SPEED]*column("wind_m_s"))):(answer("least_safety")) with lines lt nth(STRONG, n) lw 0.8 dt 3, \
         for [n=1:words(STRONG)] SWEEP using (pick(of(nth(STRONG, n)), PER[SPEED]*column("wind_m_s"))):(answer(safety_of(n))) with lines lt nth(STRONG, n), \
         for [n=1:words(STRONG)] SUMMARY using (pick(of(nth(STRONG, n)), PER[SPEED]*column("wind_m_s"))):(column(safety_of(n))) with points lt nth(STRONG, n) lw 1
}
load HERE.'strip.gp'
set key maxcols KEY_COLUMNS
plot 2 with lines, for [n=1:words(STRONG)] keyentry with linespoints lt nth(STRONG, n) title key_name(nth(STRONG, n))
unset multiplot
set output
