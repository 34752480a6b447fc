# SPDX-License-Identifier: GPL-3.0-or-later
# Open the picture, WIDTH by HEIGHT pixels of a screen; a printed page takes 640 pixels across.
if (ends(OUT, '.pdf')) {
    set terminal pdfcairo noenhanced color size WIDTH/96.0,HEIGHT/96.0 font "DejaVu Sans,11" fontscale 0.62
} else { if (ends(OUT, '.large.png')) { # of a document, for a printer
    set terminal pngcairo noenhanced size 2.5*WIDTH,2.5*HEIGHT font "DejaVu Sans,11" fontscale 2.5 linewidth 2.5 pointscale 2.5
} else { if (ends(OUT, '.png')) {
    set terminal pngcairo noenhanced size WIDTH,HEIGHT font "DejaVu Sans,11"
} else {
    set terminal svg noenhanced dynamic size WIDTH,HEIGHT font "DejaVu Sans,11"
}}}
set output OUT
