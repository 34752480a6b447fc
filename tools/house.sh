#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Measures of the source tree with their limits: one line each, "OVER" and exit code 1 where a limit is passed.
# Given: the build folder of a finished build. What a measure counts is said above it; a measure whose tool is
# not installed is skipped with a line. All of it takes some seconds.
build=${1:-build}
allow=tools/house_allow.txt
bad=0
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT

limit() { # text, number found, limit[, file with the places]
    mark=
    if [ "$2" -gt "$3" ]; then mark=' OVER' bad=1; fi
    printf '%-58s %5d (limit %d)%s\n' "$1" "$2" "$3" "$mark"
    if [ -n "$mark" ] && [ -n "$4" ]; then sed 's/^/    /' "$4"; fi
}
skip() { printf '%-58s skipped: %s\n' "$1" "$2"; }

# Files of the program and the library.
find src -type f \( -name '*.[ch]' -o -name '*.cpp' \) | sort >"$scratch/files"
limit 'files in src' "$(wc -l <"$scratch/files")" 499
xargs wc -l <"$scratch/files" | awk '$2 != "total" && $1 > 700' >"$scratch/long"
limit 'files over 700 lines' "$(wc -l <"$scratch/long")" 0 "$scratch/long"

# docs/design.md: files of a room that its list lacks, and files named anywhere in it that are not there. In the lists
# a name without an ending is a .c and a .h; capitals (cmd_NAME.c) stand for a name still to be chosen.
plan=docs/design.md
awk '/^\* `[a-z]+`: / { split($0, quoted, "`"); room = quoted[2] }
    /^$/ { room = "" }
    room { n = split($0, quoted, "`"); for (i = 2; i <= n; i += 2) if (quoted[i] != room || seen[room]++)
               print "src/" room "/" quoted[i] (quoted[i] ~ /\./ ? "" : ".c\nsrc/" room "/" quoted[i] ".h") }' "$plan" |
    while read -r name; do ls $name 2>/dev/null || echo "$name"; done | sort -u >"$scratch/listed"
grep '/.*/' "$scratch/files" | comm -23 - "$scratch/listed" | sed "s|\$|: not in the list of its room|" >"$scratch/plan"
grep -o '`[a-z_./]*/[a-z_0-9./]*\.[a-z]*`' "$plan" | tr -d '`' | sort -u | cat "$scratch/listed" - | while read -r name; do
    [ -e "$name" ] || [ -e "src/$name" ] || [ "${name#plots/}" != "$name" ] || echo "$name: not there" # plots: of results
done >>"$scratch/plan"
limit "files missing in $plan, or there alone" "$(wc -l <"$scratch/plan")" 0 "$scratch/plan"

# The licence, in the first line, or the second of a script.
for f in $(git ls-files src tests tools 2>/dev/null | grep -E '\.(c|h|cpp|sh|awk)$'); do
    if [ -f "$f" ]; then sed -n 1,2p "$f" | grep -q 'SPDX-License-Identifier: GPL-3.0-or-later' || echo "$f"; fi
done >"$scratch/bare"
limit 'files of src, tests, tools without a line of licence' "$(wc -l <"$scratch/bare")" 0 "$scratch/bare"

# A function runs from its signature to the "}" in the first column; a body begins with "{" in the first
# column after a line that ends in ")" (clang-format's BreakBeforeBraces: Linux). A macro's lines are no code.
xargs awk '
    FNR == 1 { start = 0; body = 0; macro = 0 }
    { was = macro; macro = /\\$/ && (was || /^[ \t]*#/) }
    was || /^[ \t]*#/ { if (!body) start = 0; next }
    body {
        if (/^}/) {
            n = FNR - start + 1
            count++
            if (n > 60) printf "%s:%d: %d lines\n", FILENAME, start, n
            body = 0; start = 0
        }
        next
    }
    /^{/ { if (start && last ~ /\)$/) body = 1; else start = 0; next }
    /^[A-Za-z_]/ && !start { start = FNR }
    /^[}]/ || /;[ \t]*(\/\*.*)?$/ || /^$/ { start = 0 }
    { last = $0; sub(/[ \t]*\/\*.*\*\/[ \t]*$/, "", last) }
    END { printf "functions %d\n", count >"/dev/stderr" }' <"$scratch/files" >"$scratch/fat" 2>"$scratch/count"
limit "functions over 60 lines ($(sed 's/functions //' "$scratch/count") read)" "$(wc -l <"$scratch/fat")" 0 "$scratch/fat"

# Modules (room/name: the .c and the .h together) that include each other, directly or through others:
# strongly connected components of the graph of includes.
xargs awk '
    function module(path) { sub(/^src\//, "", path); sub(/\.[a-z]+$/, "", path); return path }
    /^[ \t]*#[ \t]*include[ \t]*"/ {
        split($0, quoted, "\"")
        from = module(FILENAME); to = module(quoted[2])
        if (from != to && !((from, to) in edge)) { edge[from, to] = 1; out[from] = out[from] " " to }
        node[from] = 1; node[to] = 1
    }
    function reach(from, mark,    list, n, i, stack, top, at) { # everything that `from` includes
        top = 1; stack[1] = from
        while (top) {
            at = stack[top--]
            n = split(out[at], list, " ")
            for (i = 1; i <= n; i++)
                if (!((mark, list[i]) in seen)) { seen[mark, list[i]] = 1; stack[++top] = list[i] }
        }
    }
    END {
        for (m in node) reach(m, m)
        for (m in node) {
            if (!((m, m) in seen) || done[m]) continue
            line = m; done[m] = 1
            for (o in node)
                if (o != m && ((m, o) in seen) && ((o, m) in seen)) { line = line " " o; done[o] = 1 }
            print line
        }
    }' <"$scratch/files" >"$scratch/circles"
limit 'include circles' "$(wc -l <"$scratch/circles")" 0 "$scratch/circles"

# External symbols that one other file uses and no test and no example: they could be static there, or are
# listed in the allow-file under a reason. Symbols of the list that are not of this kind are over the limit too.
objects=$(sed -n 's|\(.*\)\.c[p]*$|'"$build"'/\1.o|p' "$scratch/files")
cat tests/*.[ch] tests/*.cpp docs/examples/*.c 2>/dev/null | grep -o '\bwf_[a-z0-9_]*' | sort -u >"$scratch/tested"
sed 's/#.*//; s/[ \t]//g; /^$/d' "$allow" | sort >"$scratch/allowed"
nm -A -g $objects 2>"$scratch/nm" | awk -v build="$build/src/" '
    { split($0, part, ":"); path = part[1]; sub(build, "", path); sub(/\.o$/, "", path)
      kind = $(NF - 1); name = $NF }
    kind ~ /^[TDBRGSCVWi]$/ && name ~ /^wf_[a-z0-9_]*$/ && !(name in home) { home[name] = path; next }
    kind == "U" { users[name]++; user[name] = path }
    END { for (name in home)
              if (users[name] == 0) print name, home[name], "-"
              else if (users[name] == 1 && user[name] != home[name]) print name, home[name], user[name] }' |
    grep -v "\.resolver " | sort >"$scratch/single"
join -v 1 "$scratch/single" "$scratch/tested" >"$scratch/untested"
cut -d' ' -f1 "$scratch/untested" | comm -23 - "$scratch/allowed" >"$scratch/new"
join "$scratch/untested" "$scratch/new" | sed 's/\(.*\) \(.*\) \(.*\)/\1, of \2, for \3/' >"$scratch/news"
cut -d' ' -f1 "$scratch/untested" | comm -13 - "$scratch/allowed" | sed "s|\$|: strike it off $allow|" >"$scratch/gone"
if [ -s "$scratch/nm" ]; then
    skip 'externals with one caller' "objects are missing in $build (make all)"
    bad=1
else
    limit "externals with one caller outside the list of $(wc -l <"$scratch/allowed")" "$(wc -l <"$scratch/news")" 0 "$scratch/news"
    limit 'names in that list that do not belong there' "$(wc -l <"$scratch/gone")" 0 "$scratch/gone"
    awk '{ split($2, a, "/"); split($3, b, "/"); if (a[1] == b[1]) n++ } END { print n + 0 }' "$scratch/untested" >"$scratch/same"
    printf '%-58s %5d\n' '  of those with one caller, in the same room' "$(cat "$scratch/same")"
fi

# Objects that are built again when the species table changes.
total=$(echo "$objects" | wc -l)
${MAKE:-make} -n BUILD="$build" SAN= -W src/data/species.h all 2>/dev/null | grep -c -e ' -c [^ ]*src/' >"$scratch/again"
limit "% of $total objects that data/species.h rebuilds" $(($(cat "$scratch/again") * 100 / total)) 25

# Files on the way from main to the elimination, before the room of the solvers.
what='files from main to the solver'
if ! command -v gdb >/dev/null; then
    skip "$what" 'gdb is not installed'
else
    gdb -q -batch -nx -ex 'set breakpoint pending on' -ex 'set debuginfod enabled off' -ex 'break wf_beam_newton' \
        -ex run -ex bt --args "$build/windfirm" analyze species/moso_bamboo.yaml --model models/culm.yaml \
        --wind 36km/h --no-report --quiet -o "$scratch/out" </dev/null >"$scratch/gdb" 2>&1
    sed -n 's/^#.* at \(src\/[^:]*\):[0-9]*$/\1/p' "$scratch/gdb" | grep -v '^src/solve/' | sort -u >"$scratch/way"
    if grep -q '^#.* main ' "$scratch/gdb"; then
        limit "$what" "$(wc -l <"$scratch/way")" 10 "$scratch/way"
    else
        skip "$what" 'no stack was read (no debug information?)'
    fi
fi
exit $bad
