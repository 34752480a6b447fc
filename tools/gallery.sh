#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Every kind of page in both languages, each printed page as a picture, and contact sheets to look at.
#   tools/gallery.sh WINDFIRM FOLDER [PAGE...]
# Anything that a renderer says on stderr, and any warning about a figure or page, fails.
windfirm=$1
out=$2
shift 2
rm -rf "$out" && mkdir -p "$out" || exit 1
bad=0
J=tests/data/job
{
    echo 'direction_deg,frequency,weibull_scale_m_s,weibull_shape'
    for d in 0 45 90 135 180 225 270 315; do echo $d,1,6,2; done
} >"$out/rose.csv"
kinds='assess analyze branched compare fit series papers explain wind rose extremes shelter terrain rain modes fragility table'
command_of() {
    case $1 in
    assess) echo "assess models/cards/oak.yaml --client Town --site-name Gate --tree-number 17 --assessor Person --photo $J/photo.jpg --logo $J/logo.png" ;;
    analyze) echo "analyze moso_bamboo --model moso_culm --wind 10,18,25 --directions 8" ;;
    branched) echo "analyze scots_pine --model scots_pine --soil mineral --wind 10,20" ;;
    compare) echo "compare oak beech norway_spruce scots_pine --model oak_20m --soil mineral --wind 15,25,35" ;;
    fit) echo "fit models/field/sample_pull.yaml --no-rival" ;;
    series) echo "series oak --model culm --wind 8 --duration 4 --step 0.5 --gust cosine --no-vtk --explain --keys 2" ;;
    papers) echo "papers tang2012 --no-vtk" ;;
    extremes) echo "wind extremes --annual docs/examples/annual.csv --wind 20,25" ;;
    explain) echo "explain oak --model culm --wind 8" ;;
    wind) echo "wind kaimal --duration 60 --points 3 --components 3" ;;
    rose) echo "wind rose --file $out/rose.csv" ;;
    shelter) echo "shelter --model scots_pine --species scots_pine --slabs 4 --cells 16" ;;
    terrain) echo "terrain --size 4 --relief 20" ;;
    rain) echo "rain --staged --duration 2" ;;
    modes) echo "modes oak --model culm --wind 0,10" ;;
    fragility) echo "fragility oak --model culm --samples 40" ;;
    table) echo "assess docs/examples/cards.csv --design en1991 --basic-wind 25 --samples 64 --reports $2" ;;
    esac
}
for kind in ${*:-$kinds}; do
    for lang in en zh; do
        to=$out/$kind-$lang
        written=$to
        [ "$kind" != table ] || written=$to.csv # of a table: it, and a folder a tree
        # shellcheck disable=SC2046
        "$windfirm" $(command_of "$kind" "$to") --lang "$lang" -q -o "$written" 2>"$to.said" || bad=1
        grep -E 'warning \[(no-figure|no-figures|no-pdf|no-picture|figure-warning)\]|^windfirm:|^error' "$to.said" && bad=1
        for pdf in "$to"/*.pdf "$to"/*/*.pdf; do
            [ -e "$pdf" ] || continue
            said=$(pdftoppm -r 70 -png "$pdf" "$(dirname "$pdf")/page" 2>&1)
            [ -z "$said" ] || { echo "$pdf: $said"; bad=1; }
        done
        [ -n "$(find "$to" -name 'page-*.png' | head -1)" ] || { echo "$to: no pages"; bad=1; }
    done
done
python=$(sed -n '1s/^#!//p' "$(command -v weasyprint)")
for lang in en zh; do
    said=$(find "$out" -path "*-$lang/*page-*.png" | sort | xargs "$python" tools/sheet.py "$out/sheet-$lang.png" 2>&1)
    [ -z "$said" ] || { echo "sheet-$lang: $said"; bad=1; }
done
ls "$out"/sheet-*.png
[ $bad = 0 ] || { echo 'gallery: something was said' >&2; exit 1; }
