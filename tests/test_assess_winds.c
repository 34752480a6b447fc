/* SPDX-License-Identifier: GPL-3.0-or-later */
/* windfirm assess: wind from all around, how often, the whole model, stiffness from a fit. */
#include "close.h"
#include "shell.h"

/* What is not assessed of the tree of a fit, whose stem is judged in the whole, and of a card. */
static void whole_stem(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W fit $S -o $T/pull -q --no-report; for l in en zh; do $W assess --from $T/pull --wind 20 "
          "--samples 0 "
          "--no-pdf -q -o $T/out --lang $l; grep -c 'the middle of the crown\\.\\|树冠中部以上的主干。' "
          "$T/out/report.html; grep -c '<li>Limbs, forks and unions\\.<\\|<li>大枝、分叉与枝干结合处。<' "
          "$T/out/report.html; done; $W assess models/cards/oak.yaml --samples 0 --no-pdf -q -o $T/o; grep "
          "-c "
          "'<li>Limbs, forks and unions; the stem above the middle of the crown\\.<' $T/o/report.html",
          CODE_OK,
          { "0\n1\n0\n1\n1\n" } },
    };
    CHECK(rows);
}

/* A tree drawn with all its branches, and the card of its sizes: its critical wind lies within the interval
 * of the card, whose own is 0.76 to 0.89 of it. Sizes are those of the drawing: 11.51 m high, 348 mm
 * thick at 1.3 m, limbs from 2.2 m on that reach 7.57 m by 7.17 m. */
static void full_model(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "for s in oak beech ash; do full=$($W analyze $s --model models/broadleaf.yaml --wind 20 --samples "
          "0 --soil "
          "mineral --no-report -o $T/f | sed -n 's/.*critical wind speed \\([0-9.]*\\).*/\\1/p'); card=$($W "
          "assess "
          "--species $s --height 11.51m --dbh 348mm --bark none --crown-width 7.37m --crown-base 2.2m --wind "
          "20 --soil "
          "mineral | sed -n 's/.*critical wind: \\([0-9.]*\\) m.*/\\1/p; s/.*samples between \\([0-9]*\\) "
          "and "
          "\\([0-9]*\\) .*/\\1 \\2/p'); echo $full $card | awk '{ print ($1 > $3 && $1 < $4), ($2 / $1 > "
          "0.6), "
          "($2 / $1 < 1), $0 }'; done 2>/dev/null",
          CODE_OK,
          { "1 1 1 21.66", "\n1 1 1 30.84", "\n1 1 1 23.0" } },
    };
    CHECK(rows);
}

/* The elastic limit is nearest in one direction, and overturning loses the tree in another. */
static void every_direction_counts(void **state)
{
    (void)state;
    static const struct row rows[] = {
        /* of a tree that is lost far below the given wind the direction that comes first is found: a thicker
           stem is lost in more wind */
        { "(echo species,height_m,dbh_m,crown_width_m,crown_base_m,lean_deg,lean_towards_deg; for d in "
          "0.2242 0.2466; "
          "do echo weeping_willow,13.28,$d,7.15,1.46,15,90; done) >$T/t.csv; $W assess $T/t.csv -o $T/o.csv "
          "-q --soil "
          "mineral --wind 20; python3 -c \"import csv; c = [float(r['wf_critical_wind_m_s']) for r in "
          "csv.DictReader(open('$T/o.csv'))]; print(c[0] < c[1], c)\"",
          CODE_OK,
          { "True" } },
        { "(echo species,height_m,dbh_m,crown_width_m,crown_base_m,lean_deg,lean_towards_deg; echo "
          "oak,20,0.8,14,4,0,90) >$T/t.csv; $W assess $T/t.csv -o $T/o.csv -q --wind 20 && cut -d, -f 8 "
          "$T/o.csv",
          CODE_OK,
          { "assessed" } },
        /* of a ridge the weakest direction is found, whatever the model's axes */
        { "for n in 0deg 40deg; do $W assess --species oak --height 20m --girth 2.5m --crown-width 14m "
          "--crown-base 4m --soil mineral --wind 20 --samples 0 --dem docs/examples/heights.asc --at "
          "1700,1450 "
          "--north $n | grep 'against over\\|y wind\\|gov.*dir' | cut -c1-44; done",
          CODE_OK,
          { "overturning      0.74", "wind from 270 deg", "wind from 95 deg" } },
        { "$W assess --species oak --height 20m --girth 2.5m --crown-width 14m --crown-base 4m --lean 9deg "
          "--wind "
          "20 --samples 0",
          CODE_OK,
          { "(--lean-towards): directions are as if it leaned towards 90 deg" } },
        /* a spruce 100 times as high as thick does not stand under its crown: it is said, in a table too */
        { "A='--soil mineral --samples 0 --wind 20'; $W assess --species norway_spruce --height 35m --dbh "
          "0.35m "
          "--crown-width 5.25m --crown-base 24.5m $A; (echo "
          "species,height_m,dbh_m,crown_width_m,crown_base_m; "
          "echo norway_spruce,35,0.33,6,20) >$T/t.csv; $W assess $T/t.csv -o $T/o.csv -q $A; cat $T/o.csv",
          CODE_OK,
          { "critical wind: fails under its own weight",
            "lost under its own weight, without wind. A tree that", " self-weight ", ",0,0,,breakage," } },
        /* a share of the wind, with snow, says nothing of the whole without it */
        { "A='--species oak --height 18m --dbh 0.6m --crown-width 10m --crown-base 4m --soil mineral "
          "--samples 64'; "
          "$W assess $A --wind 20 --snow 20cm --winter-wind 0.4; $W assess $A --wind 20 --lean 45deg",
          CODE_OK,
          { "INCOMPLETE: what was", "with what is on it in 40 % of this wind", "LOST: as computed",
            "90 % of 64 samples between 0 and" } },
        { "$W assess --species oak --height 18m --dbh 0.6m --crown-width 10m --crown-base 4m --cavity "
          "9m:20mm "
          "--wind 20 --samples 0 -o $T/c --no-pdf; grep -o 'measured at 9 m is taken from 0 to 18 m' "
          "$T/c/report.html",
          CODE_OK,
          { "cavity at 9 m: taken from 0 to 18 m above the ground, the upper end is assumed",
            "\nmeasured at 9 m is taken from 0 to 18 m\n" } },
        /* insufficient in 25 m/s and lost at 25.3: page 1 does not round the one to the other */
        { "$W assess --species oak --height 18m --dbh 0.6m --crown-width 10m --crown-base 4m --season "
          "leaf_off --soil "
          "mineral --wind 25 --samples 64 -o $T/n --no-pdf -q; sed 's/<h2.*//; s/<[^>]*>/ /g' "
          "$T/n/report.html | tr -s ' ' "
          "| grep -o 'lost at [0-9.]*'",
          CODE_OK,
          { "lost at 25.3\n" } },
        /* no strength, but an anchorage: all pages are drawn */
        { "$W assess --species willow_feng1999 --height 16m --dbh 0.457m --crown-width 9.6m --crown-base "
          "3.2m "
          "--soil mineral --samples 0 --wind 20 -o $T/w --no-pdf; grep -c 'id=\"safety\"' $T/w/report.html",
          CODE_OK,
          { "Results, tables, plots and page", "\n1\n" } },
        { "O='--species oak --height 20m --girth 2.5m --crown-width 14m --crown-base 4m --lean 20deg "
          "--lean-towards 45deg --samples 0'; $W assess $O --pull-moment 900kNm --wind 34 --scenarios "
          "root_loss=0deg:120deg 2>/dev/null | grep -A3 'what is done' | tr -s ' '",
          CODE_OK,
          { "root_loss=0deg:120deg - 0.81 0.81 31.2 lost" } },
        /* a thin wall on one side of a leaning stem: lost first in wind from where the lean is, nearest to
           yielding in another; terminal, page, figure and results name both, each for what it is of */
        { "awk 'BEGIN { print \"angle_deg,outer_m,sound_m\"; for (a = 0; a < 360; a += 15) { c = cos((a - "
          "90) "
          "* 3.14159265 / 180); printf \"%d,0.398,%.4f\\n\", a, 0.098 + 0.24 * (c > 0 ? c : 0) } }' "
          ">$T/tomo.csv; $W assess --species oak --height 20m --girth 2.5m --crown-width 14m --crown-base 4m "
          "--lean 12deg --lean-towards 45deg --cavity 1.3m:$T/tomo.csv --pull-moment 300kNm --wind 25 "
          "--samples 0 -o $T/o --no-pdf | grep 'in wind from\\|governing d' | cut -c1-52; sed 's/<h2.*//' "
          "$T/o/report.html | grep -o 'wind from [0-9.]*°' | sort | uniq -c; python3 -c \"import json, math; "
          "a = "
          "json.load(open('$T/o/results.json'))['trees'][0]['assessment']; print([round(math.degrees("
          "a[k]['from']['value'])) for k in ('breakage', 'overturning')], "
          "round(math.degrees(a['from']['value'])))\"",
          CODE_OK,
          { "governing direction: wind from 225 deg, in which", "least against breakage in wind from 180 deg",
            "4 wind from 180°\n      1 wind from 225°", "[180, 225] 225" } },
    };
    CHECK(rows);
}

/* How often the critical wind blows: by the code, by annual maxima, and by the fit of these, which is the
 * same.
 */
static void how_often(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W assess models/cards/oak.yaml --samples 0 --life 50",
          CODE_OK,
          { "about 11.6 years by EN 1991-1-4", "0.086 a year, 0.99 in 50 years" } },
        { "$W wind extremes --annual docs/examples/annual.csv -o $T/ex --no-plots -q; for x in $T/ex "
          "docs/examples/annual.csv; do $W assess models/cards/oak.yaml --samples 0 --extremes $x | grep -A1 "
          "'return period' | sed 's/by .*//'; done | sort | uniq -c",
          CODE_OK,
          { "2     probability that it blows: 0.013 a year",
            "2   return period of that wind: about 74.4 years" } },
        /* the band of a fitted shape, of ten years with one outlier; and a fit without a band */
        { "(echo speed_ms; printf '%s\\n' 14 15 14.5 16 15.2 13.9 14.8 15.5 16.2 24) >$T/a.csv; $W wind "
          "extremes --annual $T/a.csv --method gev -o $T/gev --no-plots -q; $W wind extremes --dams 14 -o "
          "$T/dams --no-plots -q; for x in gev dams; do $W assess models/cards/oak.yaml --samples 0 "
          "--extremes $T/$x | grep -A2 'return period of'; done",
          CODE_OK,
          { "/gev, winds of all", "90 % band of the fit: 10.3 years to more than its longest", "/dams, winds",
            "how sure that is, is not known: the fit has no band" } },
        /* the same on page 1 and in the results; a wind below all of the band */
        { "$W wind extremes --annual docs/examples/annual.csv -o $T/ex --no-plots -q; $W assess "
          "models/cards/oak.yaml --samples 32 --extremes $T/ex -o $T/o --no-pdf -q; sed 's/<h2.*//' "
          "$T/o/report.html | sed 's/<[^>]*>/ /g' | grep -o '90 % band of [^.]*\\.\\|At the low end[^.]*'; "
          "python3 -c \"import json; a = json.load(open('$T/o/results.json'))['trees'][0]['assessment']; "
          "print(round(a['return_period_low'], 1), a['return_period_low_bound'], "
          "a['return_period_high'], a['return_period_high_bound'], a['exceedance_at_low_end'] > 0.5)\"; "
          "$W assess models/cards/oak.yaml --samples 0 --extremes $T/ex --pull-moment 5kNm | grep band",
          CODE_OK,
          { "band of the fit: once in 33 years to more than its longest return period.", "At the low end of",
            "32.9 equal None longer True", "90 % band of the fit: less than its shortest return period\n" } },
        { "$W assess models/cards/oak.yaml --samples 0 --soil unknown --extremes docs/examples/annual.csv",
          CODE_OK,
          { "more than 1000000 years by docs/examples/annual.csv",
            "< 1e-6 a year, < 0.000010 in 10 years" } },
        { "$W assess models/cards/oak.yaml --samples 0 --extremes docs/examples/annual.csv -o $T/o --no-pdf "
          "-q; grep "
          "-c '\"exceedance_a_year_text\": \"0.013\"' $T/o/results.json; grep -c '0.013 a year and 0.13 in "
          "10' "
          "$T/o/report.html",
          CODE_OK,
          { "1\n1\n" } },
        { "printf 'species,height,girth,crown width,crown base\\noak,20,2.5,14,4\\n' >$T/t.csv; $W assess "
          "$T/t.csv -o "
          "$T/o.csv --extremes docs/examples/annual.csv --wind 20 --soil mineral -q; head -1 $T/o.csv | tr , "
          "'\\n' | "
          "grep -n exceedance; cut -d, -f16-18 $T/o.csv",
          CODE_OK,
          { "wf_exceedance_a_year", "wf_exceedance_over_life" } },
        { "$W assess models/cards/oak.yaml --extremes $T/none; $W assess models/cards/oak.yaml --extremes "
          "models/cards; printf 'speed_ms\\n20\\n21\\n' >$T/a.csv; $W assess models/cards/oak.yaml "
          "--extremes $T/a.csv",
          CODE_INPUT,
          { "--extremes: ", "cannot be read", "results.json", "years" } },
    };
    CHECK(rows);
}

/* A pulling test of a made-up tree: both safeties against breakage agree, for the tree bends as the fit says.
 */
static void from_fit(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W fit $S -o $T/f --no-profile --no-rival --no-report -q && $W assess --from $T/f --wind 8 "
          "--samples 0",
          CODE_OK,
          { "against breakage      1.86", "anchorage 3.265 kN m: 0.0109 rad x 299.3 kN m/rad",
            "taken is the largest moment of the test instead, 7.928 kN m",
            "put 7.928 kN m on the ground, 0.64 times the 12.47 kN m" } },
        /* the interval too: where only the anchorage would vary, its low end is what was carried */
        { "$W fit $S -o $T/f --no-profile --no-rival --no-report -q && $W assess --from $T/f --wind 8 "
          "--samples 64 -o $T/o --no-pdf -q; python3 -c \"import json; t = "
          "json.load(open('$T/o/results.json'))['trees'][0]; a = t['verdict']['anchorage']; "
          "print(round(a['moment']['value']), round(a['moment_by_method']['value']), "
          "[v['critical_at_low_m_s'] == v['critical_at_high_m_s'] for v in t['interval']['varied'] "
          "if v['quantity'] == 'anchorage'])\"; grep -c 'largest moment that the root carried in the test' "
          "$T/o/report.html",
          CODE_OK,
          { "7928 3265 [True]" } },
        /* the same gauge as an extension of 200 mm that begins at 40 um: the section bears the same within
           its noise */
        { "mkdir $T/data; cp models/field/sample_pine.yaml $T; awk -F, 'NR == 1 { print "
          "\"t_s,force_N,root_rad,stem_rad,ext_um\"; next "
          "} { printf \"%s,%s,%s,%s,%.6f\\n\", $1, $2, $3, $4, 0.2 * $5 + 40 }' "
          "models/field/data/sample_pull.csv "
          ">$T/data/pull.csv; sed 's/sample_pull.csv/pull.csv/; s/clino_root_rad/root_rad/; "
          "s/clino_stem_rad/stem_rad/; s/kind: "
          "strain, column: strain_um_m/kind: extension, column: ext_um, offset: yes/; s/sigma: 5e-6/sigma: 1 "
          "um/' $S >$T/s.yaml; "
          "$W fit $T/s.yaml -o $T/f --no-profile --no-rival --no-report -q && $W assess --from $T/f --wind 8 "
          "--samples 0 | grep -o "
          "'the section bears [0-9.]*'",
          CODE_OK,
          { "the section bears 22\n" } },
        { "cp models/field/sample_pine.yaml $T; sed 's|data/sample|'$PWD'/models/field/data/sample|' $S "
          ">$T/s.yaml; sed -i "
          "'/^crown/,$d' $T/sample_pine.yaml; $W fit $T/s.yaml -o $T/f --no-profile --no-rival --no-report "
          "-q "
          "&& $W assess --from "
          "$T/f --wind 8",
          CODE_INPUT,
          { "the model that was fitted has no crown, and wood alone catches too little wind" } },
        { "$W fit $S -o $T/f --no-profile --no-rival --no-report -q && $W assess --from $T/f --wind 8 "
          "--samples 0 "
          "--pull-moment '5 kN*m' --soil mineral -o $T/o --no-report -q && grep -c 'role' $T/o/results.json",
          CODE_OK,
          { "\n" } },
        { "$W fit $S -o $T/f --no-profile --no-rival --no-report -q && $W assess --from $T/f --wind 8 "
          "--samples "
          "0",
          CODE_OK,
          { "the least reduction of the crown was not searched: no branches are drawn that could be cut "
            "back" } },
        /* what the record says is on the page, in both languages */
        { "$W fit $S -o $T/f --no-profile --no-rival --no-report -q && $W assess --from $T/f --wind 8 "
          "--samples 0 -o $T/p --no-pdf -q; grep -c 'to the limit strain 0.003 the section bears' "
          "$T/p/report.html; "
          "$W report $T/p --lang zh --no-pdf -q; grep -c '至极限应变 0.003 时截面承受' $T/p/report.html",
          CODE_OK,
          { "1\n1\n" } },
        { "cp $S $T/s.yaml; cp models/field/sample_pine.yaml $T; mkdir $T/data; cp "
          "models/field/data/sample_pull.csv "
          "$T/data; $W fit $T/s.yaml -o $T/f --no-profile --no-rival --no-report -q; echo '#' >>$T/s.yaml; "
          "$W assess "
          "--from $T/f --wind 8",
          CODE_INPUT,
          { "s.yaml has changed since it was fitted" } },
        /* a record of wind and tilt, made up from 300 kN m/rad: stiffness and verdict, no strength straight
           from it */
        { "cp models/field/sample_pine.yaml $T; printf "
          "'t_s,wind_m_s,root_rad,stem_rad\\n0,4,0.005107,0.01135\\n"
          "1,6,0.011667,0.025669\\n2,8,0.020661,0.045839\\n3,10,0.031201,0.069095\\n4,12,0.039693,0."
          "087634\\n' "
          ">$T/w.csv; printf 'fit: wind\\nname: Wind\\nsource: made up\\ntrees: [{name: pine, species: "
          "scots_pine, model: "
          "sample_pine.yaml, root_stiffness: 300 kN m/rad}]\\ntests:\\n  - {name: gale, data: w.csv, time: "
          "t_s, wind: "
          "{column: wind_m_s}, sensors: [{name: plate, kind: tilt, column: root_rad, height: 0 m, sigma: "
          "0.005 deg}, "
          "{name: stem, kind: tilt, column: stem_rad, height: 4 m, sigma: 0.01 deg}]}\\nfree: [{parameter: "
          "level0.youngs_modulus, start: 5 GPa}, {parameter: root.stiffness, start: 1000 kN m/rad}]\\n' "
          ">$T/w.yaml; $W fit "
          "$T/w.yaml -o $T/f --no-profile --no-rival --no-report -q && $W assess --from $T/f --wind 8 "
          "--samples 0",
          CODE_OK,
          { "anchorage 3.263 kN m: 0.0109 rad x 299.1 kN m/rad",
            "gale, plate: the plate turned by up to 2.27 deg, in a wind of 12 m/s\n",
            "it stood that wind, which is above the critical wind of 4.1",
            "a stiffness at small tilt does not give the anchorage's strength beyond it" } },
        { "$W assess --from $T/f --wind 8 --species oak --height 3m --girth 1m --dbh 3cm --crown-base 2m "
          "--lean 20deg --lean-towards 9 2>&1 | grep -c 'has no effect with --from: the tree is that of the "
          "fit'",
          CODE_OK,
          { "7\n" } },
        { "$W fit $S -o $T/f --no-profile --no-rival --no-report -q; $W assess models/cards/oak.yaml --from "
          "$T/f; $W assess --from $T/f --wind 8 --scenarios lean=3deg; printf 'species\n' >$T/t.csv; $W "
          "assess "
          "$T/t.csv -o $T/o.csv --wind 8 --from $T/f",
          CODE_INPUT,
          { "oak.yaml:5:9: error: height: has no effect with --from: the tree is that of the fit",
            "scenario 'lean=3deg': lean: has no effect with --from", "--from: has no effect with a table" } },
        { "$W fit $S -o $T/f --no-profile --no-rival --no-report -q; $W assess --from $T/f --wind 8 "
          "--samples 0 "
          "--card Harry",
          CODE_OK,
          { "Harry: Scots pine" } },
        { "$W analyze oak $RUN -q; $W assess --from $T/out --wind 8",
          CODE_INPUT,
          { "is no results folder of windfirm fit" } },
    };
    CHECK(rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(how_often), cmocka_unit_test(full_model),
                                        cmocka_unit_test(every_direction_counts), cmocka_unit_test(from_fit),
                                        cmocka_unit_test(whole_stem) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
