#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The headers that are installed (src/windfirm.h and what it includes, as `make headers` lists them): not more
# than 15, each compiles by itself as C17 and as C++17, has its extern "C", and every name that it declares at
# file scope, and every macro, begins with wf_ or WF_. Given: the headers. Says what is wrong, exit code 1.
cc=${CC:-cc} cxx=${CXX:-c++}
warn='-Wall -Wextra -Wpedantic -Wshadow -Werror -fsyntax-only'
bad=0
complain() { echo "$*"; bad=1; }

if [ $# -gt 15 ]; then complain "$# installed headers, 15 are allowed: $*"; fi
for h in "$@"; do
    $cc -std=c17 $warn -Isrc -include "$h" -x c /dev/null || bad=1
    $cxx -std=c++17 $warn -Isrc -include "$h" -x c++ /dev/null || bad=1
    [ "$h" = src/windfirm.h ] || grep -q '^extern "C" {' "$h" || complain "$h: no extern \"C\""
done

# Macros, from the text; names, from the tokens of the preprocessed header: tags, enumerators, and whatever stands
# before a ( [ ; = or , outside of braces and parentheses.
grep -Hn '^#define' "$@" | grep -v '#define WF_' && bad=1
for h in "$@"; do
    $cc -E -std=c17 -Isrc "$h" | awk -v header="$h" '
    /^#/ { split($0, line, "\""); here = line[2] == header; next }
    here { text = text "\n" $0 }
    function name(n) { if (n !~ /^(wf_|WF_)/) { print header ": the name " n; bad = 1 } }
    END {
        gsub(/"[^"]*"/, "s", text)
        gsub(/__attribute__ *\(\([^;]*\)\)/, "", text)
        while (match(text, /[A-Za-z_][A-Za-z_0-9]*|[^ \t\n]/)) {
            t = substr(text, RSTART, RLENGTH); text = substr(text, RSTART + RLENGTH)
            if (t == "{") { depth++; list = tag_enum; start = 1 }
            else if (t == "}") { depth--; list = 0 }
            else if (t == "(" && !depth) { if (!paren && last ~ /^[A-Za-z_]/) name(last); paren++ }
            else if (t == ")" && !depth) paren--
            else if (!depth && !paren && t ~ /^[[;=,]$/ && last ~ /^[A-Za-z_]/) name(last)
            else if (list && start && t ~ /^[A-Za-z_]/) { name(t); start = 0 }
            else if (list && t == ",") start = 1
            if (t ~ /^[A-Za-z_]/) {
                if (last ~ /^(struct|enum|union)$/ && !depth) name(t)
                tag_enum = !depth && (t == "enum" || last == "enum")
            }
            last = t
        }
        exit bad
    }' || bad=1
done
exit $bad
