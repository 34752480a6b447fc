#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Run every windfirm command in the fenced blocks of README.md and docs/*.md, from a scratch folder with the shipped files beside
# it, as a reader would in the source folder. Each must end with 0. Figures and pages are left out (--no-report, --no-plots) except
# where a later command draws them again. What a block says behind "> " is compared with what the command above it prints. Given: the
# windfirm to run. The last line is "N passed, N failed, N skipped".
windfirm=$(realpath "$1")
top=$(pwd)
here=$(mktemp -d) || exit 1
trap 'rm -rf "$here"' EXIT
passed=0 failed=0 skipped=0

mkdir "$here/build" "$here/bin"
for name in models species validation docs reports; do ln -s "$top/$name" "$here/$name"; done
ln -s "$windfirm" "$here/build/windfirm"
ln -s "$windfirm" "$here/bin/windfirm"
WINDFIRM_SHARE=$top
PATH=$here/bin:$PATH
export WINDFIRM_SHARE PATH

# Commands, one a line: joined where they go on after a backslash, remarks cut off.
commands() {
    awk '/^```/ { inside = !inside; next }
         inside { if (more != "") { sub(/^ +/, ""); $0 = more " " $0; more = "" }
                  if (sub(/ *\\$/, "")) { more = $0; next }
                  sub(/ +# .*/, ""); print }' "$@" | grep -E '^(build/)?windfirm '
}

# What a command is said to print, a line behind "> " each: "command<TAB>text", blanks as one.
promises() {
    awk '/^```/ { inside = !inside; last = more = ""; next }
         inside { if (more != "") { sub(/^ +/, ""); $0 = more " " $0; more = "" }
                  if (sub(/ *\\$/, "")) { more = $0; next } }
         inside && /^(build\/)?windfirm / { last = $0; sub(/ +# .*/, "", last); next }
         inside && /^> / && last != "" { sub(/^> */, ""); gsub(/[ \t]+/, " "); print last "\t" $0 }' "$@"
}

# Does the log hold all that is promised of a command? Prints what is missing.
keeps_promises() {
    tr -s ' \t' '  ' <log >squeezed
    awk -F '\t' -v c="$1" '$1 == c { print $2 }' promised | while read -r text; do
        grep -qF -e "$text" squeezed || echo "$text"
    done >missing
    [ ! -s missing ]
}

# What is not run, and why.
reason_to_skip() {
    case "$1" in
    *"--bootstrap 200"*) echo "takes minutes; tests/test_fit_cmd.c has a smaller one" ;;
    "windfirm validate") echo "the whole validation is run by tests/run.sh itself" ;;
    esac
}

# The option that leaves the pages out; nothing where a report is drawn from the folder.
without_pages() {
    case "$1" in
    *"-o out/mine"* | *" report "* | *" --no-pdf"*) return ;;
    esac
    "$windfirm" "$(echo "$1" | cut -d' ' -f2)" --help 2>/dev/null | grep -oE -m1 -e '--no-(report|plots)'
}

commands README.md docs/*.md | sort -u >"$here/list"
# what others read is written first; those that read what another writes come last
{ grep -E 'windfirm init ' "$here/list"; grep -vE 'windfirm init | report |tree info tree.csv|--from out' "$here/list"; grep -E ' report |tree info tree.csv|--from out' "$here/list"; } >"$here/order"
promises README.md docs/*.md >"$here/promised"
cd "$here" || exit 1
while read -r line; do
    why=$(reason_to_skip "$line")
    if [ -n "$why" ]; then
        echo "skipped: $line ($why)"
        skipped=$((skipped + 1))
        continue
    fi
    pages=$(without_pages "$line")
    command=$line
    [ -n "$pages" ] && command=$(echo "$line" | sed "s/ >.*//; s/\$/ $pages/")
    if timeout 100 sh -c "$command" >log 2>&1 </dev/null; then
        if keeps_promises "$line"; then
            passed=$((passed + 1))
        else
            echo "FAILED: $line does not print:"
            cat missing
            failed=$((failed + 1))
        fi
    else
        echo "FAILED: $command (exit code $?)"
        tail -n 5 log
        failed=$((failed + 1))
    fi
done <order
if [ $((passed + failed)) -lt 20 ]; then # the blocks were not found
    echo "FAILED: only $((passed + failed)) commands were found"
    failed=$((failed + 1))
fi
echo "$passed passed, $failed failed, $skipped skipped"
[ $failed -eq 0 ]
