#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Kill a run at random moments and look at the folder it leaves. It must hold the results of the run before, those of
# this run, or files of both (a mixture) that `windfirm report` refuses or marks. The next run into the folder must
# succeed and leave no hidden file.
#
#   tests/kill_runs.sh WINDFIRM [KILLS [OPTION...]]     KILLS: 200; OPTIONs: of `windfirm compare`, such as --no-report
#
# Half of the kills are spread over the whole run, half over its last tenth, in which files are moved. The last line
# counts; exit code 1 when a mixture was not noticed or a folder could not be used again.
set -u
program=$(cd "$(dirname "$1")" && pwd)/$(basename "$1") kills=${2:-200}
shift
[ $# -eq 0 ] || shift
work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 2
SOURCE_DATE_EPOCH=1000000000
export SOURCE_DATE_EPOCH

compare() { # speeds, option...
    speeds=$1
    shift
    exec "$program" compare moso_bamboo weeping_willow --model moso_culm --wind "$speeds" -q -o folder "$@" 2>/dev/null
}
state() { # digests of everything but hidden files; a PDF differs from run to run in its identifier
    (cd "$1" && find . -name '.?*' -prune -o -type f ! -name '*.pdf' -exec sha256sum {} + | sed 's/"name": "report.pdf".*//' | sort)
}
listed() { # results.json without the digest of the PDF
    sed '/report\.pdf/d' "$1/results.json" 2>/dev/null | sha256sum
}
whole() { # folder, the one it should be like
    [ "$(state "$1" | grep -v results.json)" = "$(state "$2" | grep -v results.json)" ] && [ "$(listed "$1")" = "$(listed "$2")" ]
}

(compare 10,15 "$@")
mv folder first
start=$(date +%s%N)
(compare 12,18 "$@")
span=$((($(date +%s%N) - start) / 1000))
mv folder second
old=0 new=0 noticed=0 unnoticed=0 stuck=0 n=0
while [ $n -lt "$kills" ]; do
    n=$((n + 1))
    rm -rf folder
    cp -r first folder
    wait=$(awk -v n=$n -v span=$span 'BEGIN { srand(n); x = rand(); print span / 1e6 * (n % 2 ? x : 0.92 + 0.14 * x) }')
    (compare 12,18 "$@") &
    run=$!
    sleep "$wait"
    kill -9 $run 2>/dev/null
    wait $run 2>/dev/null
    if whole folder first; then
        old=$((old + 1))
    elif whole folder second; then
        new=$((new + 1))
    else
        cp -r folder seen
        if "$program" report folder >/dev/null 2>said && [ ! -s said ]; then
            unnoticed=$((unnoticed + 1))
            echo "not noticed, killed after $wait s:"
            (cd seen && ls -la . tables plots)
        else
            noticed=$((noticed + 1))
        fi
        rm -rf seen
    fi
    if ! (compare 12,18 --no-report) || ls -A folder | grep -q '^\.'; then
        stuck=$((stuck + 1))
        ls -A folder
    fi
done
echo "$kills kills: $old the run before, $new this run, $noticed mixtures noticed, $unnoticed not noticed, $stuck folders not usable again"
[ $((unnoticed + stuck)) -eq 0 ]
