# SPDX-License-Identifier: GPL-3.0-or-later
# Loaded by the figures of a report: its trees and wind speeds.
trees = int(number('trees', 0))
array NAME[trees]; array HEIGHT_M[trees]; array AZIMUTH[trees]; array ROWS[trees]; array CRITICAL[trees]; array SOLVED[trees]
do for [i=1:trees] {
    NAME[i] = text_of('NAME', i); HEIGHT_M[i] = number('HEIGHT_M', i); AZIMUTH[i] = number('AZIMUTH', i)
    ROWS[i] = int(number('ROWS', i)); CRITICAL[i] = number('CRITICAL', i); SOLVED[i] = text_of('SOLVED', i)
}
winds = int(number('winds', 0))
array WIND[winds]
do for [i=1:winds] { WIND[i] = number('WIND', i) }
# The key has fewer columns when the names are long.
KEY_COLUMNS = 3
do for [i=1:trees] {
    do for [k=1:2] { if (KEY_COLUMNS > 1 && short(NAME[i], 500/KEY_COLUMNS - 20) ne NAME[i]) { KEY_COLUMNS = KEY_COLUMNS - 1 } }
}
KEY_ROWS = (trees + KEY_COLUMNS - 1)/KEY_COLUMNS
key_name(i) = short(NAME[i], 500/KEY_COLUMNS - 20)
STRONG = text_of('STRONG', 0)
SPEED_MAX = number('SPEED_MAX', 0)
speed(u) = sprintf('%g m/s', u)
