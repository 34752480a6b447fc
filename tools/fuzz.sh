#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Run the fuzzers of a build. Given: the folder it was built in, seconds for each, how many at once (0: all),
# names of readers. What they find is written below that folder: BUILD/run/NAME/corpus, log and crashes. One
# line a reader; exit code 1 when one crashed. "fuzz.sh has-libfuzzer": whether clang can build them.
if ! printf 'int LLVMFuzzerTestOneInput(const char *d, long n) { return !d && n; }' |
    clang -fsanitize=fuzzer,address,undefined -x c - -o /dev/null 2>/dev/null; then
    [ "$1" != has-libfuzzer ] || exit 1
    echo "no clang with libFuzzer (Debian packages clang, libclang-rt-*-dev): fuzzing is left out"
    exit 0
fi
[ "$1" != has-libfuzzer ] || exit 0

one() { # folder, seconds, reader
    run=$1/run/$3 stored=
    rm -rf "$run/crashes"
    mkdir -p "$run/corpus" "$run/crashes"
    for d in "tests/fuzz/corpus/$3" "tests/fuzz/crashes/$3"; do
        if [ -d "$d" ]; then stored="$stored $d"; fi
    done
    TMPDIR=$run "$1/tests/fuzz/$3" -max_total_time="$2" -timeout=30 -rss_limit_mb=2048 -max_len=65536 \
        -print_final_stats=1 -artifact_prefix="$run/crashes/" "$run/corpus" $stored >"$run/log" 2>&1
    code=$?
    runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$run/log")
    edges=$(sed -n 's/.* cov: \([0-9]*\) .*/\1/p' "$run/log" | tail -n 1)
    # an input that is merely slow, on a machine where all readers run at once, is no crash; -timeout is
    crashes=$(find "$run/crashes" -type f ! -name 'slow-unit-*' | wc -l)
    if [ $code -ne 0 ] && [ "$crashes" -eq 0 ]; then crashes=1; fi
    printf '%-14s%10s runs%8s edges covered%4s crashes\n' "$3:" "${runs:-0}" "${edges:-0}" "$crashes"
    if [ "$crashes" -ne 0 ]; then
        grep -E 'broken promise|ERROR|runtime error|SUMMARY|Test unit written' "$run/log" | head -n 5 | sed 's/^/    /'
    fi
    [ "$crashes" -eq 0 ] && [ "${runs:-0}" -gt 0 ]
}

if [ "$1" = one ]; then
    one "$2" "$3" "$4"
    exit
fi
build=$1 seconds=$2 jobs=$3
shift 3
printf '%s\n' "$@" | xargs -P "$jobs" -n 1 "$0" one "$build" "$seconds"
code=$? # 123: one of them failed
[ $code -eq 0 ]
