# SPDX-License-Identifier: GPL-3.0-or-later
# Rooms from the ground up. A file includes its own room or a lower one; never a higher one. The program, main.c,
# and the header of the library, windfirm.h, stand above all rooms.
BEGIN {
    n = split("base data grow wind load solve fail study fit cases out cmd", room, " ")
    for (i = 1; i <= n; i++) rank[room[i]] = i
    for (i = 1; i < ARGC; i++) {
        split(ARGV[i], path, "/")
        if (path[2] in rank) used[path[2]] = 1
    }
    for (i = 1; i <= n; i++)
        if (!(room[i] in used)) { print "there is no room " room[i]; bad = 1 }
}
/^[ \t]*#[ \t]*include[ \t]*"/ {
    split(FILENAME, path, "/"); split($0, quoted, "\""); split(quoted[2], target, "/")
    from = path[2]; to = target[1]; why = ""
    if (from == "main.c" || from == "windfirm.h") next
    if (!(to in rank))                               why = "names no room"
    else if (to != from && rank[to] >= rank[from])   why = "points up or sideways"
    if (why) { printf "%s:%d: include \"%s\" %s\n", FILENAME, FNR, quoted[2], why; bad = 1 }
}
END { exit bad }
