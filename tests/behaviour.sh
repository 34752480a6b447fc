#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Do two builds behave alike? For a refactoring: run the commands below with both programs and compare, byte by
# byte, what is printed, the exit code and every file that is written.
#
#   tests/behaviour.sh OLD NEW        two source folders, each with its build/windfirm
#
#   ONLY=REGEX     only commands that match (extended regular expression)
#   KEEP=FOLDER    leave both trees of output there: old/NUMBER and new/NUMBER
#   LINES=NUMBER   lines of a difference that are shown [40]
#   WINDFIRM_REFERENCE=FOLDER   measured trees that are not shipped; without it their commands are left out
#
# One line a command: "same" or "DIFFERS", then the difference. Exit code: 0 all the same, 1 some differ,
# 2 usage. Every command runs in an empty folder of its own, in which
#   species, models, validation, tests/data   are copies of OLD's, for both programs;
#   made        holds the input files made below;
#   share       is the program's own source folder, its WINDFIRM_SHARE;
#   reference   is WINDFIRM_REFERENCE.
# PDF pages are not printed: a stand-in for WeasyPrint writes the size of the page.
set -u

fail() {
    echo "behaviour.sh: $*" >&2
    exit 2
}
[ $# -eq 2 ] || fail "usage: tests/behaviour.sh OLD NEW, two source folders with build/windfirm"
old=$(cd "$1" 2>/dev/null && pwd) || fail "$1: no such folder"
new=$(cd "$2" 2>/dev/null && pwd) || fail "$2: no such folder"
for checkout in "$old" "$new"; do
    [ -x "$checkout/build/windfirm" ] || fail "$checkout/build/windfirm: not there; make it first"
done
only=${ONLY:-} lines=${LINES:-40} reference=${WINDFIRM_REFERENCE:-}
[ -z "$reference" ] || reference=$(cd "$reference" 2>/dev/null && pwd) || fail "WINDFIRM_REFERENCE: no such folder"

# The commands, one a line; lines that begin with # are headings. Those that name `reference` are left out where
# there is none.
commands() {
    cat <<'END'
# help and schemas
windfirm
windfirm --help
windfirm help
windfirm --version
windfirm help compare
windfirm analyze --help
windfirm compare --help
windfirm fit --help
windfirm explain --help
windfirm import --help
windfirm papers --help
windfirm report --help
windfirm schema --help
windfirm shelter --help
windfirm series --help
windfirm simulate-test --help
windfirm species --help
windfirm terrain --help
windfirm tree --help
windfirm validate --help
windfirm wind --help
windfirm schema species
windfirm schema model
windfirm schema fit
windfirm schema study
windfirm papers schema

# species; once by the folder that is compiled in
windfirm species list
windfirm species show moso_bamboo
windfirm species show willow_feng1999
env -u WINDFIRM_SHARE windfirm species show oak

# analyze: solvers, presets, profiles, averaging times, directions, trees
windfirm analyze moso_bamboo -m moso_culm --wind 5:25:10
windfirm analyze moso_bamboo -m moso_culm --wind 10 --solver linear --lang zh
windfirm analyze moso_bamboo -m moso_culm --wind 10 --solver chain --no-report
windfirm analyze moso_bamboo -m moso_culm --wind 10 --solver chain-as-printed --no-report
windfirm analyze moso_bamboo -m moso_culm --wind 10 --solver deflect --no-report
windfirm analyze moso_bamboo -m moso_culm --wind 10 --solver deflect-as-printed --no-report
windfirm analyze moso_bamboo -m moso_culm --wind 10 --solver rod --no-report
windfirm analyze moso_bamboo -m moso_culm --wind 10 --solver rod-as-printed --no-report
windfirm analyze moso_bamboo -m moso_culm --wind 10,15 --preset tang2012 --no-report
windfirm analyze poplar -m culm --wind 10 --preset zhao2013 --no-report -q
windfirm analyze willow_feng1999 -m culm --wind 8 --preset feng1999 --no-report
windfirm analyze oak -m culm --wind '36,54 km/h' --profile log --roughness '5 cm' --temperature -5 --altitude 800 --no-report
windfirm analyze oak -m culm --wind 20 --profile canopy --displacement 7 --reference-height 20 --root-stiffness 1e6 --no-report
windfirm analyze oak -m culm --wind 10 --profile-file made/profile.csv --directions 8
windfirm analyze oak -m culm --wind beaufort:8,cma:typhoon,30 --no-report
windfirm analyze oak -m culm --wind 30,40 --averaging-time 3 --no-report
windfirm analyze oak -m culm --wind 20 --averaging-time '1 h' --averaging in-land --no-report
windfirm analyze oak -m culm --wind 10,20 --climate made/rose.csv --north 30 --lang zh
windfirm analyze oak -m culm --wind 15 --climate made/rose.csv --dem made/hill.asc --at 500,600 --threads 2 --no-report
windfirm analyze oak -m culm --wind 10 --speed-up 1.2 --azimuth 40 --shelter wake --air-density 1.1 --search-to 60 --no-report
windfirm analyze poplar --tree tests/data/qsm/normalised.csv --leaf-area 1 --unload --wind 10
windfirm analyze poplar --tree tests/data/qsm/warts.csv --season leaf_off --joint bridge --wind 10,20 --mesh-tolerance 1e-3 --no-report
windfirm analyze oak --study models/studies/bamboo_and_willow.yaml --wind 7 --no-report
env WINDFIRM_REFERENCE=reference windfirm analyze ash --tree reference/trees/qsm/wytham_T20_leafoff.csv --wind 10 --no-report

# compare, report
windfirm compare moso_bamboo weeping_willow --model culm --wind 10,15,25 -o out/mine
windfirm compare models/studies/bamboo_and_willow.yaml --no-report
windfirm compare oak ash beech -m culm --wind 12 --directions 8 --no-report -q && windfirm report out/compare && cp out/compare/report.html english.html && windfirm report out/compare --lang zh
env -u WINDFIRM_SHARE sh -c 'windfirm analyze species/oak.yaml -m models/culm.yaml --wind 12 --no-report -q && windfirm report out/analyze -q'

# series, explain, papers
windfirm series moso_bamboo -m moso_culm --wind 10 --gust cosine --period 10 --duration 5 --step 0.5
windfirm series oak -m culm --no-vtk --duration 4 --gust von-karman --set length=80,share-up=0.4 --seed 3 --no-report
windfirm series oak -m culm --no-vtk --duration 2 --gust kaimal --components 1 --solver deflect --damping 5 --restoring 0.3 --no-report
windfirm series oak -m culm --no-vtk --duration 2 --gust kaimal --shelter wake --profile log --no-report
windfirm series oak -m culm --no-vtk --duration 30 --step 1 --gust record --file made/sonic.csv --no-report
windfirm series poplar -m zhao2013_ifs --wind 10 --gust sine-perlin --solver deflect --duration 2 --leaf-motion noise --no-vtk --explain
windfirm series oak --study models/studies/bamboo_and_willow.yaml --wind 8 --duration 6 --no-vtk --no-report
windfirm explain poplar -m zhao2013_ifs --wind 5
windfirm explain moso_bamboo -m moso_culm --wind hko:typhoon --profile uniform --azimuth 90 --no-report
windfirm papers tang2012 --no-vtk --no-report
windfirm papers made/runs.yaml

# wind, shelter, terrain
windfirm wind list
windfirm wind kaimal --components 3 --points 3 --spacing 2 --duration 200 --seed 7
windfirm wind von-karman --wind 12 --duration 100 --intensity 0.15 --set length=80 --no-plots
windfirm wind davenport --duration 100 --wind beaufort:8 --height 20 --no-plots
windfirm wind one-over-f --duration 100 --step 0.2 --no-plots
windfirm wind cosine --duration 60 --no-plots
windfirm wind sine-perlin --duration 60 --no-plots
windfirm wind sine-perlin-as-printed --duration 60 --no-plots
windfirm wind perlin --duration 60 --set octaves=3 --no-plots
windfirm wind eog --wind 25 --set start=2,duration=8
windfirm wind record --file made/sonic.csv --columns t_s,u_ms,v_ms,w_ms
windfirm wind rose --file made/rose.csv
windfirm wind kaimal --components 3 --points-file made/points.csv --duration 100 --stream wind.npy
windfirm wind kaimal --points 3 --spacing 3 --duration 50 --stream wind.csv
windfirm wind --study models/studies/bamboo_and_willow.yaml --wind 8 --no-plots
windfirm shelter -m scots_pine -s scots_pine --wind 15 --slabs 12 --cells 48 --no-motion
windfirm shelter -m culm -s oak --wind 15 --slabs 8 --cells 32 --law feng1999 --as energy --azimuth 30
windfirm shelter --tree tests/data/qsm/normalised.csv -s oak --leaf-area 4 --wind beaufort:9 --slabs 8 --cells 32 --gap 2 --no-plots
windfirm terrain --size 5 --relief 20 --seed 3 --from 240
windfirm terrain --dem made/hill.asc --positions made/places.csv --height 20 --roughness 0.1 -o out/site

# import, tree
for q in archi.csv hand.csv normalised.csv plain.csv rtwig.csv simpleforest.csv treeqsm_23.txt treeqsm_24.txt treeqsm_archi.txt treeqsm_comma.txt walnut.mtg warts.csv; do windfirm import tests/data/qsm/$q -o $q.csv || echo "exit code $?"; done
windfirm import tests/data/qsm/plain.csv tests/data/qsm/truncated.csv made/nothing.csv tests/data/qsm/archi.csv -o all/
windfirm import tests/data/qsm/normalised.csv -o tree.txt && windfirm import tests/data/qsm/normalised.csv -o tree.vtk
windfirm import tests/data/qsm/archi.csv --length-unit cm --diameter-unit mm -o tree.csv
windfirm tree info --csv -q tests/data/qsm/*
windfirm tree info tests/data/qsm/warts.csv tests/data/qsm/walnut.mtg
windfirm tree info tests/data/qsm/plain.csv --species moso_bamboo --leaf-area 12 --joint bridge
windfirm tree info tests/data/qsm/normalised.csv --density 800
windfirm tree draw tests/data/qsm/normalised.csv -o tree.svg
windfirm tree draw -m weeping_willow_tree -s weeping_willow -o willow.svg
windfirm tree draw -m zhao2013_ifs -s poplar -o ifs.png
windfirm tree draw -m moso_branched -s moso_bamboo --season leaf_off -o moso.svg
windfirm tree info reference/trees/qsm/*.csv reference/trees/qsm/*.txt reference/trees/qsm/*.mat reference/trees/qsm/*.mtg
windfirm import reference/trees/qsm/wytham_T14.mat -o t14.csv && windfirm import reference/trees/qsm/openalea_walnut_noylum2.mtg -o walnut.csv

# fit, simulate-test
windfirm fit models/field/sample_pull.yaml --write mine.yaml && windfirm species show mine.yaml
windfirm fit models/field/sample_two_trees.yaml --no-report --no-profile --write two.yaml
windfirm fit models/field/slash_pine_1.yaml --priors --free level0.youngs_modulus,root.stiffness --no-report
windfirm fit models/field/slash_pine_2.yaml --loss huber --loss-scale 2 --no-report --no-profile
windfirm fit models/field/oil_palm_leaf.yaml --no-profile --no-rival
windfirm fit models/field/sample_pull.yaml --loss tukey --starts 2 --bootstrap 4 --seed 7 --no-report --no-profile --no-rival
windfirm simulate-test tests/data/fit/wind_moment.yaml --seed 3 -o sim && windfirm fit tests/data/fit/wind_moment.yaml --data sim/gusts.csv --no-report --no-rival
windfirm simulate-test tests/data/fit/moso_wind.yaml -o sim
windfirm fit models/field/sample_pull.yaml --loss cauchy --no-report --no-profile -q
windfirm simulate-test models/field/sample_pull.yaml
windfirm simulate-test models/field/sample_two_trees.yaml --free level0.youngs_modulus,each:root.stiffness --seed 4
env WINDFIRM_REFERENCE=reference windfirm fit models/field/mangrove_gladstone_15.yaml --no-report --write mangrove.yaml

# validate
windfirm validate validation/closed_form validation/potential validation/field
windfirm validate --verbose --order validation/computed_reference/tree_T7_A.case validation/computed_reference/elastica_tip.case validation/computed_reference/tree_Y3_A.case
windfirm validate validation/computed_reference/buckling_taper.case validation/computed_reference/frequency_t1.case validation/computed_reference/frequency_tree_T7.case validation/computed_reference/reconfiguration_W2.case validation/computed_reference/bend45_Jtors.case
windfirm validate made/wrong.case
windfirm validate made/broken.case species made/none.case

# mistakes in what is typed
windfirm analyse
windfirm qqqqqq
windfirm analyze oak -m culm --wind 10 --wnd 3 --solver bem --profile lgo --altitude 1kg --exponent 2
windfirm analyze oak
windfirm analyze oak --model culm --tree tests/data/qsm/plain.csv --wind 10
windfirm analyze oak -m culm --wind 10 --wind 5 --quiet=yes --solver
windfirm analyze a b -m culm --wind 10
windfirm compare oak -m culm --wind 10
for w in abc '' , nan 1e999 -5,300 10kg 10km/h,20 5:40 40:5:1 5:40:0 0:200:0.001 beaufort:99 beufort:8; do windfirm analyze oak -m culm --wind "$w"; echo "exit code $?"; done
windfirm analyze oak -m culm --wind 20 --averaging-time 90 --averaging in-land
windfirm analyze oak -m culm --wind 20 --averaging drst --directions 7
windfirm analyze oak -m culm --wind 10 --profile log --reference-height 5 --displacement 6
windfirm analyze oak -m culm --wind 10 --climate made/rose.csv --directions 12
windfirm analyze oak -m culm --wind 10 --dem made/hill.asc
windfirm analyze oak -m culm --wind 10 --profile measured
windfirm analyze oak -m culm --wind 10 --profile canopy
windfirm analyze oak -m culm --wind 10 --no-report -o made/profile.csv/out
windfirm explain poplar
windfirm series oak -m culm --wind 10,20 --gust kaimal --intensity 5 --set lenght=3
windfirm series oak -m culm --gust kaimal --set lenght=3
windfirm series oak -m culm --gust record
windfirm series oak -m culm --gust cosine --file x.csv
windfirm wind kaiml
windfirm wind kaimal --points 300
windfirm wind kaimal --points 3 --points-file made/points.csv
windfirm shelter -m culm -s oak --wind beaufort:19 --slabs 0 --cells 4.5 --as engery
windfirm terrain extra
windfirm terrain --size 2.5 --smoothness 3
windfirm terrain --dem made/none.asc
windfirm tree inf x
windfirm tree draw -o a.svg
windfirm tree draw tests/data/qsm/plain.csv -o a.gif
windfirm tree info tests/data/qsm/plain.csv --species no_such_tree --density 9 --joint glue
windfirm import tests/data/qsm/plain.csv tests/data/qsm/archi.csv -o t.csv
windfirm import tests/data/qsm/plain.csv -o t.obj
windfirm import tests/data/qsm/warts.csv --strict --format tree
windfirm import tests/data/qsm/warts.csv --strict -q
windfirm species lst
windfirm species show nothing
windfirm schema tree
windfirm report nowhere
windfirm report out --lang fr
windfirm papers tang2021
windfirm papers made/badruns.yaml
windfirm fit models/field/sample_pull.yaml --free level0.youngs_modulos
windfirm fit models/field/sample_pull.yaml --free root.stiffness,root.stiffness
windfirm fit models/field/sample_pull.yaml --data more.csv --loss hubr --starts 0
windfirm fit models/field/sample_pull.yaml --data more.csv
windfirm fit tests/data/fit/wind_moment.yaml
windfirm fit models/field/wytham_t3.yaml
windfirm simulate-test models/culm.yaml
windfirm validate --ordr nowhere

# mistakes in files
windfirm species show tests/data/bad/species.yaml
windfirm analyze tests/data/bad/species.yaml -m made/badmodel.yaml --wind 10
windfirm compare tests/data/bad/species.yaml made/none.yaml -m made/badmodel.yaml --wind 10
windfirm analyze made/unit.yaml -m culm --wind 10
windfirm analyze made/plain.yaml -m culm --wind 10
windfirm analyze made/large.yaml -m culm --wind 10
windfirm analyze made/empty.yaml -m culm --wind 10
windfirm analyze made/cycle.yaml -m culm --wind 10
windfirm analyze made/bytes.yaml -m culm --wind 10
windfirm analyze species -m culm --wind 10
windfirm analyze oak --study made/badstudy.yaml
windfirm analyze oak --study models/culm.yaml
windfirm analyze oak --study made/empty.yaml
windfirm analyze oak --study made/none.yaml
windfirm analyze oak -m culm --wind 10 --profile-file made/badprofile.csv
windfirm analyze oak -m culm --wind 10 --climate made/badrose.csv
windfirm wind rose --file made/shortrose.csv
windfirm wind kaimal --points-file made/badpoints.csv --stream wind.npy
windfirm wind record --file made/badsonic.csv
windfirm wind record --file made/calm.csv --columns t_s,u_ms
windfirm terrain --dem made/badhill.asc
windfirm terrain --dem made/hill.asc --positions made/badplaces.csv
windfirm fit made/badfit.yaml
windfirm fit made/badpull.yaml --no-report
windfirm import tests/data/qsm/truncated.csv made/rose.csv made/empty.yaml tests
END
}

# Input files beside those of OLD.
make_inputs() {
    printf 'height_m,speed_ms\n2,3\n5,4\n10,5\n' >profile.csv
    printf 'height_m,speed_ms\n5,4\n2,x\n5,6\n' >badprofile.csv
    awk 'BEGIN { print "direction_deg,frequency,weibull_scale_ms,weibull_shape"
        for (d = 0; d < 360; d += 45) print d "," 0.05 + d / 1800 "," 5 + d / 90 ",1.8" }' >rose.csv
    sed 's/^45,[^,]*/46,-1/; s/,1\.8$/,-3/' rose.csv >badrose.csv
    sed '$d' rose.csv >shortrose.csv
    printf 'x_m,y_m,z_m\n0,0,5\n0,2,5\n1,0,12\n' >points.csv
    printf 'x_m,y_m,z_m\n0,0,-1\na,0,1\n' >badpoints.csv
    awk 'BEGIN { print "t_s,u_ms,v_ms,w_ms"
        for (i = 0; i < 600; i++)
            printf "%.1f,%.3f,%.3f,%.3f\n", i / 10, 6 + 2 * sin(i / 11) + sin(i * 1.7), 3 + cos(i * 2.3), 0.3 * sin(i) }' |
        sed '50s/,[^,]*/,NA/; 200d' >sonic.csv
    sed '20s/^[^,]*/0/' sonic.csv >badsonic.csv
    awk 'BEGIN { print "t_s,u_ms"; for (i = 0; i < 60; i++) print i ",calm" }' >calm.csv
    awk 'BEGIN { printf "ncols 41\nnrows 41\nxllcorner 0\nyllcorner 0\ncellsize 25\n"
        for (r = 0; r < 41; r++) { for (c = 0; c < 41; c++)
            printf "%.3f ", 60 / (1 + ((c - 20) ^ 2 + (r - 24) ^ 2) / 64); print "" } }' >hill.asc
    sed '6s/^[^ ]*/x/' hill.asc >badhill.asc
    printf 'x_m,y_m\n500,600\n130.5,220\n' >places.csv
    printf 'x_m,y_m\n500,6000\ny,220\n' >badplaces.csv

    cat >runs.yaml <<'E'
runs_of: mine
title: A few runs
source: "made for a comparison"
runs:
  - {name: gusts, species: oak, model: culm, wind: 10 m/s, gust: perlin, set: octaves=3, duration: 2 s, profile: log, roughness: 5 cm}
  - {name: shelter, species: weeping_willow, model: ../models/papers/willow_few_twigs.yaml, solver: rod, gust: cosine,
     intensity: 0.25, period: 10 s, wind: 6 m/s, duration: 4 s, step: 2 s, keys: 2, shelter: feng1999}
  - {name: printed, species: poplar, model: zhao2013_ifs, preset: zhao2013, gust: sine-perlin-as-printed,
     profile: uniform, wind: 10 m/s, duration: 1 s, step: 0.1 s, keys: 4, restoring: 0.3, explain: yes}
E
    sed 's/species: oak/speces: oak/; s/10 m\/s/10 kg/; s/sine-perlin-as/sine-perlin-az/' runs.yaml >badruns.yaml
    sed 's/height:/heigth:/; s/law: [a-z]*/law: lineal/' ../models/culm.yaml >badmodel.yaml
    sed 's/value: 10 GPa/value: 10 GPx/; s/ density:/ densty:/' ../species/moso_bamboo.yaml >unit.yaml
    sed 's/value: 10 GPa/value: 10/' ../species/moso_bamboo.yaml >plain.yaml
    sed 's/value: 10 GPa/value: 10000 GPa/' ../species/moso_bamboo.yaml >large.yaml
    : >empty.yaml
    printf 'a: &x [*x]\n' >cycle.yaml
    printf 'species: \377\n' >bytes.yaml
    printf 'study: x\nwnd: 10\nmodel: culm\nsolver: bem\naltitude: 1 kg\nquiet: maybe\n' >badstudy.yaml
    sed 's/height: 4 m/height: 40 m/; s/kind: tilt/kind: tlt/; s/GPa/Gpa/' ../models/field/sample_pull.yaml >badfit.yaml
    sed 's|data/sample_pull.csv|badpull.csv|; s|sample_pine|../models/field/sample_pine|' ../models/field/sample_pull.yaml >badpull.yaml
    printf 't_s,force_N,clino_root_rad,clino_stem_rad,strain_um_m\n0,1,x,0,0\n1,2,0,0,0\n0,3,0,0,0\n' >badpull.csv
    sed 's/^\(want .*[^0-9]\)[0-9][0-9.]*\( .*\)*$/\1 77/' ../validation/computed_reference/elastica_tip.case >broken.case
    cat >wrong.case <<'E'
title           A mast pulled at the top, with a wrong value
kind            closed-form
source          nobody
cantilever      6 m
radius          40 mm
youngs_modulus  70 GPa
poisson         0.33
solver          linear chain
tolerance       1e-9
force           tip 100 0 0 N
want moment base y        601 N m
E
}

unset LINES WINDFIRM_REFERENCE
export PYTHONDONTWRITEBYTECODE=1 LC_ALL=C.UTF-8 SOURCE_DATE_EPOCH=1700000000 WINDFIRM_SHARE=share
if [ -n "${KEEP:-}" ]; then
    mkdir -p "$KEEP" && work=$(cd "$KEEP" && pwd) || fail "KEEP: $KEEP cannot be made"
    [ -z "$(ls -A "$work")" ] || fail "KEEP: $KEEP is not empty"
else
    work=$(mktemp -d) || exit 2
    trap 'rm -rf "$work"' EXIT
    trap 'exit 2' INT TERM HUP
fi
inputs="$work/inputs"

mkdir -p "$inputs/made" "$inputs/tests" "$work/old" "$work/new" "$work/bin/old" "$work/bin/new"
cp -R "$old/species" "$old/models" "$old/validation" "$inputs" && cp -R "$old/tests/data" "$inputs/tests" ||
    fail "$old: not a source folder"
(cd "$inputs/made" && make_inputs)
ln -s "$old/build/windfirm" "$work/bin/old/windfirm"
ln -s "$new/build/windfirm" "$work/bin/new/windfirm"
# windfirm runs reports/pdf.py by the Python in the first line of the program weasyprint. Here that is the true Python with
# a module weasyprint that prints a page without content; -E would hide it. Builds without pdf.py run the program itself.
python=$(command -v python3) || fail "python3: not there"
cat >"$work/bin/python3" <<E
#!/bin/sh
[ "\$1" != -E ] || shift
PYTHONPATH='$work/bin' exec '$python' "\$@"
E
cat >"$work/bin/weasyprint.py" <<'E'
import logging

LOGGER = logging.getLogger('weasyprint')


class HTML:
    pages = [None]

    def __init__(self, **page):
        self.size = len(page['string'])

    def render(self):
        return self

    def write_pdf(self, name):
        with open(name, 'w') as pdf:
            pdf.write('%%PDF of a page of %d bytes\n%%%%EOF\n' % self.size)
E
cat >"$work/bin/weasyprint" <<E
#!$work/bin/python3
import sys
import weasyprint

with open(sys.argv[-2], 'rb') as page:
    weasyprint.HTML(string=page.read()).write_pdf(sys.argv[-1])
E
chmod +x "$work/bin/weasyprint" "$work/bin/python3"

# What differs of necessity, in what is printed: the source folder, where it is compiled in (the longer name first:
# one may lie in the other); processor time of `wind --stream`.
longer=$old shorter=$new
[ ${#old} -ge ${#new} ] || longer=$new shorter=$old
normalise() {
    sed "s|$longer/|SOURCE/|g; s|$shorter/|SOURCE/|g; s/in [0-9.]* s of processor time/in TIME s of processor time/"
}

run() { # side, its source folder, number, command
    here="$work/$1/$3"
    mkdir -p "$here" && cd "$here" || exit
    ln -s "$2" share
    for input in species models validation tests made; do ln -s "$inputs/$input" $input; done
    [ -z "$reference" ] || ln -s "$reference" reference
    PATH="$work/bin/$1:$work/bin:$PATH" sh -c "$4" >"$here.out" 2>"$here.err" </dev/null
    echo $? >exit_code
    rm -f share species models validation tests made reference
    normalise <"$here.out" >stdout
    normalise <"$here.err" >stderr
    rm -f "$here.out" "$here.err"
}

number=0 total=0 same=0 differ=0 skipped=0
commands >"$work/commands"
while IFS= read -r command <&3; do
    number=$((number + 1))
    case $command in '' | '#'*) continue ;; esac
    if [ -n "$only" ] && ! printf '%s\n' "$command" | grep -Eq -e "$only"; then continue; fi
    case $reference:$command in :*' reference/'* | :*'=reference '*)
        skipped=$((skipped + 1))
        continue
        ;;
    esac
    (run old "$old" $number "$command") &
    (run new "$new" $number "$command")
    wait
    total=$((total + 1))
    if (cd "$work" && diff -ru old/$number new/$number) >"$work/difference" 2>&1; then
        same=$((same + 1))
        printf 'same     %s\n' "$command"
    else
        differ=$((differ + 1))
        printf 'DIFFERS: %s\n' "$command"
        cut -c 1-240 "$work/difference" | sed "${lines}q" | sed 's/^/    /'
        shown=$(wc -l <"$work/difference")
        [ "$shown" -le "$lines" ] || echo "    ... $((shown - lines)) more lines"
    fi
    [ -n "${KEEP:-}" ] || rm -rf "$work/old/$number" "$work/new/$number"
done 3<"$work/commands"

[ $skipped -eq 0 ] || echo "$skipped left out: WINDFIRM_REFERENCE names no folder"
(cd "$work" && rm -rf inputs bin difference commands)
echo "$total commands, $same same, $differ differ"
[ $differ -eq 0 ]
