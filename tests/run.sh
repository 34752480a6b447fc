#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Run the checks of layers, symbols and installed headers, every test program, the commands of the documentation and the
# validation cases of a build; the last line is
# "N passed, N failed" (", N skipped" when there are any). Given: the build folder.
build=$1
log=$build/tests/log
passed=0 failed=0 skipped=0
WINDFIRM=$build/windfirm
export WINDFIRM
# with address sanitizers (make SAN=1 test): a pointer to what stood on the stack of a function that has returned
export ASAN_OPTIONS="${ASAN_OPTIONS:-detect_stack_use_after_return=1}"

number() { # the number in front of a word on the log's last matching line, 0 when there is none
    n=$(sed -n "s/$1/\\1/p" "$log" | tail -n 1)
    echo "${n:-0}"
}

mkdir -p "$build/tests"
for what in layers symbols interface; do
    if ${MAKE:-make} -s $what; then
        passed=$((passed + 1))
    else
        echo "FAILED: $what"
        failed=$((failed + 1))
    fi
done

program() { # name, command: counts the tests of a program
    name=$1
    shift
    "$@" >"$log" 2>&1 </dev/null
    code=$?
    p=$(number '.*\[  PASSED  \] \([0-9]*\) test.*')
    f=$(number '.*\[  FAILED  \] \([0-9]*\) test.*')
    s=$(number '.*\[  SKIPPED \] \([0-9]*\) test.*')
    if [ $code -ne 0 ] && [ "$f" -eq 0 ]; then f=1; fi # it crashed or never reported
    if [ $((p + f + s)) -eq 0 ]; then f=1; fi          # a program without tests proves nothing
    if [ "$f" -ne 0 ]; then cat "$log"; fi
    echo "$name: $p passed, $f failed, $s skipped"
    passed=$((passed + p)) failed=$((failed + f)) skipped=$((skipped + s))
}

for source in tests/test_*.c; do
    name=$(basename "$source" .c)
    program "$name" "$build/tests/$name"
done
for source in tests/fuzz/read_*.c; do # every stored input through every reader
    name=$(basename "$source" .c | sed 's/^read_//')
    program "fuzz/$name" "$build/tests/fuzz/$name" "$name" tests/fuzz/corpus/*/* tests/fuzz/crashes/*/*
done

sh tests/docs.sh "$WINDFIRM" >"$log" 2>&1 </dev/null
p=$(number '.*[^0-9]*\b\([0-9][0-9]*\) passed.*') f=$(number '.*\b\([0-9][0-9]*\) failed.*') s=$(number '.*\b\([0-9][0-9]*\) skipped.*')
if [ $((p + f + s)) -eq 0 ]; then f=1; fi
if [ "$f" -ne 0 ]; then cat "$log"; else grep '^skipped:' "$log"; fi
echo "commands of the documentation: $p passed, $f failed, $s skipped"
passed=$((passed + p)) failed=$((failed + f)) skipped=$((skipped + s))

"$WINDFIRM" validate >"$log" 2>&1 </dev/null
code=$?
p=$(number '.*[^0-9]*\b\([0-9][0-9]*\) passed.*') f=$(number '.*\b\([0-9][0-9]*\) failed.*') s=$(number '.*\b\([0-9][0-9]*\) skipped.*')
if [ $code -ne 0 ] && [ "$f" -eq 0 ]; then f=1; fi
if [ $((p + f + s)) -eq 0 ]; then f=1; fi
if [ "$f" -ne 0 ]; then
    grep -E 'FAILED|: error:' "$log"
    echo "('$WINDFIRM validate' shows all of it)"
fi
echo "validation cases: $p passed, $f failed, $s skipped"
passed=$((passed + p)) failed=$((failed + f)) skipped=$((skipped + s))

line="$passed passed, $failed failed"
if [ $skipped -ne 0 ]; then line="$line, $skipped skipped"; fi
echo "$line"
[ $failed -eq 0 ]
