# Readings against load: points measured, line predicted, band 95 % of the prediction.
#   gnuplot -c fit_readings.gp FOLDER [FILE]
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'fit_readings.svg'
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
READINGS = DIR.'/tables/readings.csv'
SHOWN = GROUPS > 8 ? 8 : GROUPS
ROWS = (SHOWN + 1)/2
WIDTH = 640.0; HEIGHT = 230.0*ROWS + 10
in(g) = column("group") == g
@start
set multiplot
unset key
do for [g=1:SHOWN] {
    i = g - 1; x0 = (i%2) ? 396.0 : 72.0; y1 = HEIGHT - 28.0 - 230.0*(i/2)
    set lmargin at screen x0/WIDTH; set rmargin at screen (x0 + 232)/WIDTH
    set tmargin at screen y1/HEIGHT; set bmargin at screen (y1 - 150)/HEIGHT
    set title GROUP[g] offset 0,-0.6
    set xlabel GROUP_X[g]; set ylabel GROUP_Y[g] offset 1,0
    FREE = GROUP_X[g] eq 'free sway'
    set xrange [*:*]; if (FREE) { set xrange [-1:1]; set xtics ("" 0); set yrange [0:*] } else { set xtics autofreq; set yrange [*:*] }
    plot READINGS using (pick(in(g) && !FREE, column("load"))):(pick(in(g), column("predicted")-column("band_95"))):(pick(in(g), column("predicted")+column("band_95"))) with filledcurves fs solid 0.2 noborder lt 1, \
         '' using (pick(in(g), FREE ? 0 : column("load"))):(pick(in(g), column("measured"))):"sigma" with yerrorbars lt 2 lw 0.8 dt 1 pt 7 ps 0.35, \
         '' using (pick(in(g) && !FREE, column("load"))):(pick(in(g), column("predicted"))) with lines lt 1, \
         '' using (pick(in(g) && FREE, 0.25)):(pick(in(g), column("predicted"))):"band_95" with yerrorbars lt 1 lw 1.2 pt 4 ps 0.7
}
unset multiplot
set output
