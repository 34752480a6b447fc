# A gusty wind: the first ten minutes, its spectrum against the target, its histogram.
#   gnuplot -c wind.gp FOLDER [FILE]
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'wind.svg'
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
SERIES = DIR.'/tables/series.csv'
SPECTRUM = DIR.'/tables/spectrum.csv'
HISTOGRAM = DIR.'/tables/histogram.csv'
array WORD[3] = ['along', 'across', 'up']
WIDTH = 640.0; HEIGHT = 570.0
stats SPECTRUM using (column("frequency_hz")*column("density_m2_s")) nooutput
TOP = STATS_max
stats HISTOGRAM using 1 nooutput
# three or four ticks across the narrow panel
SPAN = (STATS_max - STATS_min)/3.0; TEN = 10.0**floor(log10(SPAN))
TICK = SPAN/TEN > 5 ? 5*TEN : SPAN/TEN > 2 ? 2*TEN : TEN
SHOWN = DURATION < 600 ? DURATION : 600
EVERY = ceil(SHOWN/STEP/3000.0)

@start
set multiplot
set lmargin at screen 84.0/WIDTH; set rmargin at screen 618.0/WIDTH
set tmargin at screen 1 - 26.0/HEIGHT; set bmargin at screen 1 - 200.0/HEIGHT
set title MODEL.": the first ".sprintf("%g", SHOWN)." s" offset 0,-0.6
set xrange [0:SHOWN]; set yrange [*:*]
set xlabel "time (s)"; set ylabel "wind (m/s)" offset 1,0
set key top right horizontal
plot for [c=COMPONENTS:1:-1] SERIES every EVERY using 1:(column(c + 1)) with lines lt c lw 0.8 dt 1 title (COMPONENTS > 1 ? WORD[c] : "")

set lmargin at screen 84.0/WIDTH; set rmargin at screen 384.0/WIDTH
set tmargin at screen 1 - 284.0/HEIGHT; set bmargin at screen 60.0/HEIGHT
set title (TARGET ? "spectrum: points made, line asked for" : "spectrum") offset 0,-0.6
set logscale xy; set xrange [*:*]; set yrange [3e-5*TOP:*]
set format xy "%g"
set xlabel "frequency (Hz)"; set ylabel "f S (m2/s2)" offset 0,0
set key bottom right vertical
is(c) = strcol("component") eq WORD[c]
plot for [c=1:COMPONENTS] SPECTRUM using (pick(is(c), column("frequency_hz"))):(column("frequency_hz")*column("density_m2_s")) with points lt c lw 1 title (COMPONENTS > 1 ? WORD[c] : ""), \
     for [c=1:(TARGET ? COMPONENTS : 0)] SPECTRUM using (pick(is(c), column("frequency_hz"))):(column("frequency_hz")*column("target_m2_s")) with lines lt c

unset logscale; set format xy "%g"
set lmargin at screen 462.0/WIDTH; set rmargin at screen 618.0/WIDTH
set title "along; line: normal" offset 0,-0.6
set xrange [*:*]; set yrange [0:*]
set xlabel "wind (m/s)"; set ylabel "share per m/s" offset 0,0
set xtics TICK
plot HISTOGRAM using 1:2 with boxes fs solid 0.35 noborder lt 1, HISTOGRAM using 1:3 with lines lt 2
unset multiplot
set output
