#!/usr/bin/awk -f
# SPDX-License-Identifier: GPL-3.0-or-later
# Largest relative change of each column between two tables of the same rows: changed.awk OLD NEW. One line a
# column that differs; columns of one table alone are named.
BEGIN { FS = "," }
FNR == 1 { file++; for (i = 1; i <= NF; i++) if (file == 1) old[$i] = i; else { new[i] = $i; columns = NF } next }
file == 1 { for (i = 1; i <= NF; i++) cell[FNR, i] = $i; rows = FNR; next }
{
    for (i = 1; i <= NF; i++) {
        if (!(new[i] in old)) continue
        a = cell[FNR, old[new[i]]]; b = $i
        if (a == b) continue
        scale = (a < 0 ? -a : a) > (b < 0 ? -b : b) ? (a < 0 ? -a : a) : (b < 0 ? -b : b)
        change = a - b; if (change < 0) change = -change
        change = scale > 0 ? change / scale : 1
        if (change > most[i]) most[i] = change
        count[i]++
    }
}
END {
    if (FNR != rows) print FILENAME ": " FNR - 1 " rows, before " rows - 1
    for (i = 1; i <= columns; i++) {
        if (!(new[i] in old)) print FILENAME ": new column " new[i]
        else if (count[i]) printf "%s: %s: %d cells, largest relative change %.3g\n", FILENAME, new[i], count[i], most[i]
    }
}
