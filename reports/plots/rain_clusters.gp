# SPDX-License-Identifier: GPL-3.0-or-later
# Points on a branch's surface, by cluster, and the nodes found from them in their order.
#   gnuplot -c rain_clusters.gp FOLDER FILE LANGUAGE
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'rain_clusters.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
POINTS = DIR.'/tables/points.csv'; NODES = DIR.'/tables/clusters.csv'
WIDTH = 640.0; HEIGHT = 260.0
load HERE.'start.gp'
set lmargin at screen 70.0/WIDTH; set rmargin at screen 618.0/WIDTH
set size ratio -1; unset colorbox; unset key
set xlabel L('RAIN_X'); set ylabel L('RAIN_Z') offset 1,0
plot POINTS using (PER_M*column("x_m")):(PER_M*column("z_m")):(int(column("cluster")) % 6 + 1) with points pt 7 ps 0.2 lc variable, \
     NODES using (PER_M*column("x_m")):(PER_M*column("z_m")) with lines lc rgb '#404040' lw 1, \
     NODES using (PER_M*column("x_m")):(PER_M*column("z_m")) with points pt 6 ps 1.1 lc rgb '#000000', \
     NODES using (PER_M*column("x_m")):(PER_M*column("z_m")):(sprintf('%d', int(column("cluster")))) with labels offset 0,1
set output
