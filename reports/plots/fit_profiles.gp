# Profile likelihood of every parameter: rise of -2 ln(likelihood) with the others refitted, and the 95 % level.
#   gnuplot -c fit_profiles.gp FOLDER [FILE]
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'fit_profiles.svg'
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
PROFILES = DIR.'/tables/profiles.csv'
SHOWN = PROFILED > 8 ? 8 : PROFILED
ROWS = SHOWN ? (SHOWN + 1)/2 : 1
WIDTH = 640.0; HEIGHT = 220.0*ROWS + 10
of_param(k) = column("parameter") == k
@start
set multiplot
unset key
set yrange [0:2.2*LIMIT]
if (!SHOWN) { unset border; unset tics; set label 1 "no profiles were asked for" at graph 0.5,0.5 center; plot [0:1] -1 }
do for [k=1:SHOWN] {
    i = k - 1; x0 = (i%2) ? 392.0 : 68.0; y1 = HEIGHT - 16.0 - 220.0*(i/2)
    set lmargin at screen x0/WIDTH; set rmargin at screen (x0 + 236)/WIDTH
    set tmargin at screen y1/HEIGHT; set bmargin at screen (y1 - 150)/HEIGHT
    set yrange [0:2.2*LIMIT]
    set xlabel PARAM[k]; set ylabel "rise" offset 1,0
    set yrange [*:*]; set xrange [*:*]
    stats PROFILES using (pick(of_param(k), column("value"))) nooutput
    SPAN = (STATS_max - STATS_min)/3.0; SPAN = SPAN > 0 ? SPAN : 1; TEN = 10.0**floor(log10(SPAN))
    TICK = SPAN/TEN > 5 ? 5*TEN : SPAN/TEN > 2 ? 2*TEN : TEN
    set xtics TICK
    plot PROFILES using (pick(of_param(k), column("value"))):"rise" with linespoints lt 1, LIMIT with lines lt 2
}
unset multiplot
set output
