# SPDX-License-Identifier: GPL-3.0-or-later
# The key stands in a strip of its own at the foot of the picture, as wide as the page: the last plot of a
# multiplot, entries alone. Its height is KEY pixels.
set lmargin at screen 0.02; set rmargin at screen 0.98; set bmargin at screen 0; set tmargin at screen KEY/HEIGHT
unset border; unset tics; unset grid; unset title; unset xlabel; unset ylabel; unset label; unset arrow; unset logscale
set xrange [0:1]; set yrange [0:1]
set key at graph 0.5, graph 0.5 center center horizontal Left reverse samplen 4 width 2
