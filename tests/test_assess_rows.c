/* SPDX-License-Identifier: GPL-3.0-or-later */
/* windfirm assess TABLE: rows beside each other, of scans, interrupted and gone on with. */
#include "close.h"
#include "shell.h"

#define WIND " --design en1991 --basic-wind 25 --terrain III --soil mineral"
#define HEAD "id,species,height_m,girth_cm,crown_width_m,crown_base_m,note\\n"

/* What is written is a file in a folder that is there; numbers that occur twice are said, as is a table that
 * an earlier command began. */
static void around_the_table(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "printf '" HEAD "7,oak,20,250,14,4,\n8,oak,20,250,14,4,\n7,oak,20,250,14,4,\n,oak,20,250,14,4,\n,"
          "oak,20,250,14,4,\n' "
          ">$T/t.csv; mkfifo $T/p; for o in $T $T/p $T/no/o.csv; do $W assess $T/t.csv -o $o --wind 20; echo "
          "$?; done; ls $T; $W "
          "assess $T/t.csv -o $T/o.csv --wind 20",
          CODE_OK,
          { ": is a folder; a file is written, for example -o assessed.csv\n2\n",
            "/p: is no file; a file is written, for example -o assessed.csv\n2\n", "/no\n2\np\nt.csv\n",
            "rows whose tree number was there before: 1, the first in line 4; each is assessed by itself" } },
        { "printf '" HEAD "7,oak,20,250,14,4,\n' >$T/t.csv; echo x >$T/o.csv.partial; echo y "
          ">$T/o.csv.partial.run; $W assess "
          "$T/t.csv -o $T/o.csv --wind 20; ls $T",
          CODE_OK,
          { "o.csv.partial is of another command or table; it is begun anew", "\no.csv\nt.csv\n" } },
    };
    CHECK(rows);
}

/* A safety just below the required one is not printed as that: table, terminal and page. */
static void just_below(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "{ echo 'species,height,girth,crown width,crown base,wind'; seq 26.20 0.0001 26.24 | sed "
          "'s/^/oak,20,2.5,14,4,/'; } >$T/t.csv; $W assess $T/t.csv -q -o $T/o.csv --wind 20; awk -F, "
          "'NR > 1 { n[$9]++; wrong += ($9 == \"insufficient\") != ($10 < 1.5) }\n"
          "END { few = n[\"insufficient\"] < 20 || n[\"incomplete\"] < 20; print few, wrong + 0 }' $T/o.csv; "
          "w=$(awk -F, '$9 == \"insufficient\" && $10 < 1.4996 { print $6; exit }' $T/o.csv); $W assess "
          "--species oak --height 20 --girth 2.5 --crown-width 14 --crown-base 4 --samples 0 --wind $w -o "
          "$T/r "
          "--no-pdf --scenarios season=leaf_off >$T/said 2>&1; grep -c INSUFFICIENT $T/said; s=$(sed -n "
          "'s/ *against breakage *\\([0-9.]*\\) .*/\\1/p' $T/said); awk \"BEGIN { x = $s < 1.5 && $s > "
          "1.498; "
          "print x }\"; grep -c \"as it stands.* $s \" $T/said; grep -c \"<b>$s</b>\" $T/r/report.html; grep "
          "-c "
          "\"<td class=.r.>$s</td>\" $T/r/report.html",
          CODE_OK,
          { "0 0\n1\n1\n1\n1\n" } },
    };
    CHECK(rows);
}

/* Rows with the file of a tree are assessed by it, others as without that column; a file that cannot be taken
 * is a mistake of its row. */
static void scans(void **state)
{
    (void)state;
#define SCANS "id,species,height_m,girth_cm,crown_width_m,crown_base_m,scan\\n"
#define TREES "mkdir $T/k; cp docs/examples/scan.csv $T/k/a.csv; cp models/oak_20m.yaml $T/k/m.yaml; "
#define ASSESS "; $W assess $T/t.csv -q -o $T/o.csv" WIND "; echo \"code $?\"; cat $T/o.csv"
    static const struct row rows[] = {
        /* the critical wind is that of analyze; the row without a file keeps its bytes */
        { TREES
          "printf '" SCANS "1,oak,14,106,6,9,\\n2,oak,14,106,6,9,k/a.csv\\n' >$T/t.csv; cut -d, -f1-6 "
          "$T/t.csv >$T/u.csv; for k in t u; do $W assess $T/$k.csv -q -o $T/$k.out --azimuth 0" WIND
          "; done; sed -n '2s/,,assessed/,assessed/p' $T/t.out >$T/1; sed -n 2p $T/u.out | cmp - $T/1 && "
          "echo as "
          "before; $W analyze --tree $T/k/a.csv oak --crown-width 6m --crown-depth 5.17m --samples 0 -o $T/r "
          "-q "
          "--no-report --azimuth 0" WIND " >$T/2 2>&1; c=$(python3 -c 'import json, sys; "
          "print(json.load(open(sys.argv[1]))[\"trees\"][0][\"verdict\"][\"critical_speed\"][\"value\"])' "
          "$T/r/results.json); sed -n '3s/\".*\"//p' $T/t.out | awk -F, -v c=$c '{ d = $16 / c - 1; print (d "
          "* d < "
          "1e-8) ? \"agrees\" : \"differs \" $16 \" \" c }'",
          CODE_OK,
          { "as before\nagrees\n" } },
        /* a model carries its own leaves; a scan none: its crown is the row's; what differs from it is said
         */
        { TREES "printf '" SCANS
                "1,oak,,,,,k/m.yaml\\n2,oak,20,106,6,9,k/a.csv\\n3,oak,14,,,,k/a.csv\\n' >$T/t.csv" ASSESS,
          CODE_OK,
          { "code 2\n",
            "assessed,\"by m.yaml in place of the card: 20 m high, 793 mm thick at 1.3 m\",lost,2.9",
            "a.csv in place of the card: 14.17 m high, 338 mm thick at 1.3 m; the row says 20 m "
            "high\",lost,0.44",
            "shows no leaves, and wood alone catches too little wind" } },
        { TREES "printf '" SCANS "4,oak,,,6,15,k/a.csv\\n5,,14,106,6,9,k/a.csv\\n' >$T/t.csv" ASSESS,
          CODE_OK,
          { "code 2\n", "the crown base of 15 m is not below that", "mistake,species: is needed" } },
        /* the same column in other languages; wood alone when the leaves have fallen */
        { TREES "printf 'Baumart;Baumdatei;Saison\\noak;k/a.csv;leaf_off\\n' >$T/t.csv; for k in Scandatei "
                "'fichier scan' \xE6\xA0\x91\xE6\xA8\xA1\xE5\x9E\x8B; do sed \"s/Baumdatei/$k/\" $T/t.csv "
                ">$T/u.csv; $W "
                "assess $T/u.csv -q -o $T/o.csv" WIND "; sed -n 2p $T/o.csv; done | cut -c1-60 | uniq -c",
          CODE_OK,
          { "3 oak;k/a.csv;leaf_off;assessed;by a.csv in place" } },
        /* a page a tree names its file; intervals */
        { TREES "printf '" SCANS
                "2,oak,14,106,6,9,k/a.csv\\n' >$T/t.csv; $W assess $T/t.csv -q -o $T/o.csv --samples 64 "
                "--reports $T/r --no-pdf" WIND
                "; grep -c 'k/a.csv' $T/r/row_2/results.json; sed 's/\".*\"//' $T/o.csv | "
                "awk -F, 'NR == 2 { print ($14 > 0 && $14 < $15) ? \"interval\" : \"none\" }'; ls $T/r/row_2",
          CODE_OK,
          { "interval\nplots\nreport.html\nresults.json\n" } },
        /* out of the folder by name, by a link, in a model; what is no file; broken, missing, too large */
        { TREES "ln -s /etc/passwd $T/k/l.csv; mkfifo $T/k/p.csv; echo hello >$T/k/b.csv; truncate -s 65M "
                "$T/k/g.csv; "
                "printf 'cavities: [{at: 1 m, rays: ../x.csv}]' >$T/k/r.yaml; printf '\"r\\\\x61ys\": x' "
                ">$T/k/s.yaml; "
                "(printf '" SCANS
                "'; for k in ../t.csv /etc/passwd k/../../x k/l.csv k k/p.csv k/b.csv k/n.csv k/g.csv "
                "k/r.yaml k/s.yaml; do echo 1,oak,14,106,6,9,$k; done) >$T/t.csv; timeout 20 $W assess "
                "$T/t.csv -q -o "
                "$T/o.csv" WIND
                "; echo code $?; for k in 'leads out' 'is no file' 'no known tree' 'No such file' 'larger "
                "than 64' 'files of its own' mistake; do grep -c \"$k\" $T/o.csv; done | tr '\\n' ' '",
          CODE_OK,
          { "code 2\n4 2 1 1 1 2 11 " } },
        /* another folder, and none without a use */
        { TREES "mkdir $T/s; printf '" SCANS
                "1,oak,14,106,6,9,a.csv\\n2,oak,14,106,6,9,../t.csv\\n3,oak,14,106,6,9,"
                "/etc/passwd\\n' >$T/s/t.csv; $W assess $T/s/t.csv --scans $T/k -q -o $T/o.csv" WIND
                "; cat $T/o.csv",
          CODE_OK,
          { "a.csv,assessed,", "'../t.csv': ", "'/etc/passwd': leads out of the folder of --scans" } },
        { "$W assess docs/examples/cards.csv -o $T/o.csv --scans $T" WIND,
          CODE_INPUT,
          { "has no column that names files" } },
        { "$W assess models/cards/oak.yaml --scans $T",
          CODE_INPUT,
          { "--scans: has no effect without a table" } },
        { TREES "printf '" SCANS
                "1,oak,14,106,6,9,a.csv\\n' >$T/t.csv; $W assess $T/t.csv --scans $T/none -o $T/o.csv" WIND,
          CODE_INPUT,
          { "none: No such file" } },
    };
    CHECK(rows);
}

/* A run that was ended goes on, with the same bytes, also behind a row that was cut; another command does
 * not. */
static void goes_on(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "(printf '" HEAD
          "'; for i in $(seq 1 150); do echo $i,oak,20,$((200+i)),14,4,; done; echo bad) >$T/t.csv; "
          "A=\"$W assess $T/t.csv -o $T/o.csv" WIND
          "\"; $A 2>/dev/null; echo $?; cp $T/o.csv $T/whole; (head -70 $T/whole; printf '70,oak,2') "
          ">$T/o.csv.partial; rm $T/o.csv; (echo \"windfirm ${A#* }\"; $W --version; sha256sum <$T/t.csv | "
          "cut -d' ' "
          "-f1) >$T/o.csv.partial.run; $A; echo $?; cmp $T/o.csv $T/whole && ls $T; cp $T/whole "
          "$T/o.csv.partial; $A "
          "2>&1 | grep -c 'goes on'; cmp $T/o.csv $T/whole",
          CODE_OK,
          { "2\n", "goes on after 69 rows", "150 assessed, 1 with mistakes",
            "2\no.csv\nt.csv\nwhole\n0\n" } },
    };
    CHECK(rows);
}

/* A row that a signal left unfinished is not written, whatever of it was there: the same command computes it.
 * The runs are given more and more time, so that one is ended among its rows however fast the machine is. */
static void interrupted_rows_are_not_written(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "(printf '" HEAD
          "'; for i in $(seq 1 59); do echo $i,oak,20,$((200+i)),14,4,; done) >$T/t.csv; A=\"$W assess "
          "$T/t.csv --samples 64" WIND
          "\"; $A -q -o $T/whole; k=0; while k=$((k+1)); timeout --foreground -s TERM "
          "--preserve-status $((k/4)).$((k%4*25)) $A -o $T/o.csv >$T/said 2>&1; c=$?; [ $c = 143 ] && [ "
          "$(cat $T/o.csv.partial 2>/dev/null | wc -l) -lt 3 ]; do :; done; echo ended $c; tail -1 $T/said; "
          "grep -c -v "
          "',assessed,.* to ' $T/o.csv.partial; head -$(wc -l <$T/o.csv.partial) $T/whole | cmp - "
          "$T/o.csv.partial && echo begins alike; $A -o $T/o.csv 2>&1 | grep -c 'goes on after'; cmp "
          "$T/o.csv $T/whole && echo alike",
          CODE_OK,
          { "ended 143\n", "the same command goes on from", "\nbegins alike\n1\nalike\n" } },
        /* rows are in the table as soon as they and those before them are finished: a second signal, which
           ends the program at once, loses none of them, although 59 rows are read together */
        { "(printf '" HEAD
          "'; for i in $(seq 1 59); do echo $i,oak,20,$((200+i)),14,4,; done) >$T/t.csv; A=\"$W assess "
          "$T/t.csv --samples 256 --threads 1" WIND
          "\"; $A -o $T/o.csv >$T/log 2>&1 & p=$!; for i in $(seq 3000); do [ "
          "\"$(cat $T/o.csv.partial 2>/dev/null | wc -l)\" "
          "-ge 4 ] && break; sleep 0.02; done; kill $p; kill $p; kill -KILL $p; wait $p; n=$(wc -l "
          "<$T/o.csv.partial); [ $n -ge 4 ] && [ $n -lt 60 ] && echo kept; $A -o $T/o.csv 2>&1 | grep -o "
          "'goes on after [0-9]* rows' >$T/said; [ \"$(cat $T/said)\" = \"goes on after $((n-1)) rows\" ] && "
          "echo "
          "goes on; grep -c assessed $T/o.csv",
          CODE_OK,
          { "kept\ngoes on\n59\n" } },
    };
    CHECK(rows);
}

/* A row's cells do not depend on the rows beside it, on threads, nor on the width of vector instructions. */
static void rows_do_not_mix(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "set -e; F=docs/examples/forty_trees.csv; A=\"-q --soil mineral --wind 25\"; $W assess $F $A -o "
          "$T/a.csv --threads 1; "
          "for l in 1 4 8; do for t in 1 2; do WINDFIRM_LANES=$l $W assess $F $A -o $T/b.csv --threads $t; "
          "cmp "
          "$T/a.csv $T/b.csv; done; done; for k in 3 17 25 42; do (head -2 $F; sed -n ${k}p $F) >$T/t.csv; "
          "$W assess "
          "$T/t.csv $A -o $T/b.csv; tail -1 $T/b.csv >$T/c; sed -n ${k}p $T/a.csv | cmp - $T/c; done; (head "
          "-2 $F; "
          "sed -n '40p;6p;41p;5p;12p' $F) >$T/t.csv; for t in 1 2; do $W assess $T/t.csv $A --samples 20 -o "
          "$T/i$t.csv --threads $t; done; cmp $T/i1.csv $T/i2.csv; (head -2 $F; sed -n '5p' $F) >$T/t.csv; "
          "$W assess "
          "$T/t.csv $A --samples 20 -o $T/b.csv; tail -1 $T/b.csv >$T/c; sed -n 3p $T/i1.csv | cmp - $T/c; "
          "echo "
          "alike",
          CODE_OK,
          { "alike\n", NULL } },
    };
    CHECK(rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(goes_on),    cmocka_unit_test(rows_do_not_mix),
        cmocka_unit_test(just_below), cmocka_unit_test(around_the_table),
        cmocka_unit_test(scans),      cmocka_unit_test(interrupted_rows_are_not_written)
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
