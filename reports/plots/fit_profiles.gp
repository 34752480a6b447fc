# SPDX-License-Identifier: GPL-3.0-or-later
# Profile likelihood of every parameter: rise of -2 ln(likelihood) with the others refitted, and the 95 % level.
#   gnuplot -c fit_profiles.gp FOLDER [FILE [LANGUAGE]]
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'fit_profiles.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
# a parameter in words, behind it its unit: "root.stiffness (kN m/rad)"
unit_in(text) = (FIT_U = strstrt(text, ' ('), FIT_U ? text[FIT_U + 2:strlen(text) - 1] : '')
parameter(text) = (FIT_O = unit_in(text), FIT_N = strlen(FIT_O) ? text[1:strstrt(text, ' (') - 1] : text, with_unit(short(L(FIT_N), SPAN), FIT_O))
PARAMS = int(number('PARAMS', 0)); PROFILED = int(number('PROFILED', 0)); LIMIT = number('LIMIT', 0)
array VALUE[PARAMS+1]; array LOW[PARAMS+1]; array HIGH[PARAMS+1]; array LOGGED[PARAMS+1]
do for [k=1:PARAMS] { PER_K = per(unit_in(text_of('PARAM', k))); VALUE[k] = PER_K*number('VALUE', k); LOW[k] = PER_K*number('LOW', k); HIGH[k] = PER_K*number('HIGH', k); LOGGED[k] = number('LOGGED', k) == 1 }
PROFILES = DIR.'/tables/profiles.csv'
SHOWN = PROFILED > 8 ? 8 : PROFILED
ROWS = SHOWN ? (SHOWN + 1)/2 : 1
WIDTH = 640.0; STEP = 222.0; HEIGHT = STEP*ROWS
SPAN = SHOWN == 1 ? 560.0 : 236.0
# what the covariance alone would say: a parabola in the value's logarithm, or in the value
parabola(k, x) = LOGGED[k] ? LIMIT*(2*log(x/VALUE[k])/log(HIGH[k]/LOW[k]))**2 : LIMIT*(2*(x - VALUE[k])/(HIGH[k] - LOW[k]))**2
of_param(k) = column("parameter") == k
load HERE.'start.gp'
set multiplot
unset key
set yrange [0:2.2*LIMIT]
if (!SHOWN) { unset border; unset tics; set label 1 L('NO_PROFILES') at graph 0.5,0.5 center; plot [0:1] -1 }
do for [k=1:SHOWN] {
    i = k - 1; x0 = (i%2) ? 392.0 : 68.0; y1 = HEIGHT - 16.0 - STEP*(i/2)
    set lmargin at screen x0/WIDTH; set rmargin at screen (x0 + SPAN)/WIDTH
    set tmargin at screen y1/HEIGHT; set bmargin at screen (y1 - 150)/HEIGHT
    set xlabel parameter(text_of('PARAM', k)); set ylabel L('RISE') offset 1,0
    set yrange [*:*]; set xrange [*:*]; PER_K = per(unit_in(text_of('PARAM', k)))
    stats PROFILES using (pick(of_param(k) && column("rise") < 4*LIMIT, PER_K*column("value"))) nooutput
    WIDE = (STATS_max - STATS_min)/(SHOWN == 1 ? 6.0 : 3.0); WIDE = WIDE > 0 ? WIDE : 1; TEN = 10.0**floor(log10(WIDE))
    TICK = WIDE/TEN > 5 ? 5*TEN : WIDE/TEN > 2 ? 2*TEN : TEN
    unset logscale x
    if (LOGGED[k] && STATS_max > 8*STATS_min) { set logscale x; set xtics autofreq } else { set xtics TICK }
    set xrange [STATS_min:STATS_max]; set yrange [0:1.3*LIMIT]; set samples 200
    set label 1 "95 %" at graph 0.5, first LIMIT center offset 0,0.6
    plot PROFILES using (pick(of_param(k), PER_K*column("value"))):"rise" with points lt 1, \
         '' using (pick(of_param(k), PER_K*column("value"))):"rise" smooth mcsplines with lines lt 1, LIMIT with lines lt 2, \
         parabola(k, x) with lines lt 1 lc rgb '#606060' lw 1 dt 3
}
unset multiplot
set output
