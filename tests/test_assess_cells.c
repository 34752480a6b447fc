/* SPDX-License-Identifier: GPL-3.0-or-later */
/* windfirm assess TABLE: cells and heads that may mean something else, and what is said once of all rows. */
#include "close.h"
#include "shell.h"

/* Winds of cells: a comma that may be decimal is refused, the unit of the head holds for each wind, and a
 * table may bring its own. */
static void own_winds(void **state)
{
    (void)state;
#define CELLS "species,height_m,girth_cm,crown_width_m,crown_base_m"
#define TREE_OF(list) "printf '" CELLS list "\n' >$T/t.csv; "
#define GO "$W assess $T/t.csv -q -o $T/o.csv "
    static const struct row rows[] = {
        { "for s in ';' '\t'; do printf '" CELLS ",wind\noak,20,250,14,4,X\noak,20,250,14,4,15.25\n"
          "oak,20,250,14,4,15@ 25\noak,20,250,14,4,25\n' | tr , \"$(printf \"$s\")\" | sed 's/X/15,25/; "
          "s/@/,/' "
          ">$T/t.csv; " GO "--wind 20; cut -d\"$(printf \"$s\")\" -f7-10 $T/o.csv | tr '\\t' ';'; done",
          CODE_OK,
          { "mistake;\"wind: '15,25' may be a decimal comma or a list; write one wind with a point, as "
            "15.25, and "
            "several winds with a blank behind each comma, as 15, 25\";\nassessed;;incomplete;4.1599\n"
            "assessed;;incomplete;1.651",
            "\nmistake;wind: '15,25' may be",
            "\nassessed;;incomplete;4.1599\n"
            "assessed;;incomplete;1.651" } },
        /* 36 and 54 km/h are 10 and 15 m/s */
        { TREE_OF(",wind_kmh\noak,20,250,14,4,\"36,54\"\noak,20,250,14,4,gust:120\noak,20,250,14,4,gust:120 "
                  "km/h\noak,20,250,14,4,18:54:18\noak,20,250,14,4,\"30,beaufort:8\"\noak,20,250,14,4,15 m/s")
              GO "--wind 20; sed 's/.*\\(assessed\\|mistake\\)/\\1/' $T/o.csv | cut -d, -f1-4",
          CODE_OK,
          { "assessed,,incomplete,4.2777\nassessed,,incomplete,2.1609\nassessed,,incomplete,2.1609\n"
            "assessed,,incomplete,4.2777\nmistake,\"wind_kmh: '30,beaufort:8' is neither",
            "\nassessed,,incomplete,4.2777\n" } },
        /* the wind of the table alone, as the option gives it */
        { TREE_OF(",wind\noak,20,250,14,4,20\noak,20,250,14,4,") GO "; echo $?; cut -d, -f7-10 $T/o.csv",
          CODE_OK,
          { "2\nwf_status", "\nassessed,,incomplete,2.584\nmistake,\"design: is needed, or --wind" } },
        { TREE_OF(",design,basic_wind,terrain\noak,20,250,14,4,en1991,25,III") GO
          "; echo $?; cut -d, -f9-12 "
          "$T/o.csv; " TREE_OF("\noak,20,250,14,4") GO
          "--design en1991 --basic-wind 25 --terrain III; cut -d, "
          "-f6-9 $T/o.csv",
          CODE_OK,
          { "0\nwf_status", "assessed,,incomplete,2.1409\nwf_status", "assessed,,incomplete,2.1409\n" } },
        { TREE_OF("\noak,20,250,14,4") GO "--lang zh", CODE_INPUT, { "没有列也没有选项给出风" } },
        /* classes and grades are not taken for m/s */
        { TREE_OF(",wind\noak,20,250,14,4,3\noak,20,250,14,4,12\noak,20,250,14,4,12 m/s\noak,20,250,14,4,13")
              GO "--wind 20; cut -d, -f7-9 $T/o.csv; " TREE_OF(",wind_m_s\noak,20,250,14,4,12") GO
          "--wind 20; cut -d, -f7-9 "
          "$T/o.csv",
          CODE_OK,
          { "\nmistake,\"wind: '3' may be a class or a grade of Beaufort; write '3 m/s' or 'beaufort:3', or "
            "name the column "
            "wind_m_s\"",
            "\nmistake,\"wind: '12' may be",
            "\nassessed,,incomplete\nassessed,,incomplete\nwf_status,wf_reason,"
            "wf_verdict\nassessed,,incomplete\n" } },
        /* a cell's wind before that of the line, in either way of giving it; what is no wind is said with its
           bytes */
        { TREE_OF(",wind\noak,20,250,14,4,20\noak,20,250,14,4,") GO
          "--design en1991 --basic-wind 25 --terrain II; cut -d, -f7-10 $T/o.csv; " TREE_OF(
              ",design,basic_wind,terrain\noak,20,250,14,4,en1991,25,III\noak,20,250,14,4,,,") GO
          "--wind 20; cut -d, "
          "-f9-12 $T/o.csv",
          CODE_OK,
          { "\nassessed,,incomplete,2.5608\nassessed,,incomplete,1.5849\n",
            "\nassessed,,incomplete,2.1409\nassessed,,incomplete,2.584\n" } },
        { TREE_OF(",wind_kmh\noak,20,250,14,4,1.2.3\noak,20,250,14,4,-5\noak,20,250,14,4,.5") GO
          "--wind 20; cut "
          "-d, -f6- $T/o.csv",
          CODE_OK,
          { "mistake,\"wind: '1.2.3': ", "'-5' is neither winds", "\n.5,assessed,,incomplete,197" } },
        /* a share of the wind beside a column of snow acts where there is snow; without one it is refused */
        { TREE_OF(",snow_cm\noak,20,250,14,4,20\noak,20,250,14,4,") GO
          "--wind 20 --winter-wind 0.4; cut -d, -f7-10 $T/o.csv; " TREE_OF(
              ",snow_cm,winter_wind\noak,20,250,14,4,20,0.4") GO "--wind 20; cut -d, -f8-11 $T/o.csv",
          CODE_OK,
          { "assessed,,incomplete,10.911\nassessed,,incomplete,2.584\nwf_status",
            "assessed,,incomplete,10.911\n" } },
        { TREE_OF("\noak,20,250,14,4") "for l in en zh; do " GO
                                       "--wind 20 --winter-wind 0.4 --lang $l 2>&1; echo $?; done; ls $T",
          CODE_OK,
          { "--winter-wind: has no effect without --snow and --ice, and no column is that\n2\n",
            "也没有这样的列\n2\nt.csv\n" } },
    };
    CHECK(rows);
}

/* Heads that surveys use for something else, columns that a row does not use, and mistakes of options. */
static void said_once(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "for h in crown_height_m Kronenhöhe 'hauteur du houppier (m)' 冠高 'distance (m)' azimuth_deg; do "
          "for l in en zh; do printf \"" CELLS ",$h\\noak,20,250,14,4,4\\n\" >$T/t.csv; " GO
          "--wind 20 --lang $l 2>&1; echo $?; done; done >$T/said; grep -c '^2$' $T/said; grep -c \"may be "
          "the height of "
          "the crown's lower edge, of its top, or its depth; name it crown_base or crown_depth\" $T/said; "
          "grep -c "
          "'可能是树冠下缘的高度' $T/said; grep -c -e 'azimuth_deg. may be the direction' -e 'distance (m). "
          "may be "
          "the spacing' -e 可能是风向 -e 可能是林分株距 $T/said; ls $T",
          CODE_OK,
          { "12\n4\n4\n4\nsaid\nt.csv\n" } },
        /* a letter or two wrong, with and without a unit; words that are not */
        { TREE_OF(
              ",cavty,required safty,heigth "
              "(m),place,street,number,notes\noak,20,250,14,4,1.3m:20mm,3,21,a,b,c,d") "$W assess $T/t.csv "
                                                                                       "-o $T/o.csv --wind "
                                                                                       "20",
          CODE_OK,
          { "'cavty' (--cavity), 'required safty' (--required-safety)",
            "only kept: 'heigth (m)', 'place', 'street', "
            "'number', 'notes'" } },
        /* the height of a sample is that of its roots, in a row as on a card */
        { "printf 'species,height,girth,crown_width,crown_base,soil,wind\\noak,20 m,2.5 m,14 m,4 "
          "m,mineral,25\\n' "
          ">$T/t.csv; $W assess $T/t.csv --samples 64 -o $T/o.csv --reports $T/r --no-pdf 2>$T/said; $W "
          "assess "
          "--species oak --height 20m --girth 2.5m --crown-width 14m --crown-base 4m --soil mineral --wind "
          "25 "
          "--samples 64 --no-pdf -o $T/c >$T/said 2>&1; for f in $T/c $T/r/*; do grep -A6 '\"low\"' "
          "$f/results.json | "
          "grep value | head -n 2 | cksum; done | uniq | wc -l",
          CODE_OK,
          { "1\n" } },
        { "$W assess --species oak --height 20m --girth 2.5m --crown-width 14m --wind '36 m/h' -o $T/o",
          CODE_INPUT,
          { "--wind: '36 m/h': 'm/h' is not a unit of a speed; use one of: m/s, km/h, knot" } },
        { TREE_OF(
              ",crown_density,rain\noak,20,250,14,4,80,700") "$W assess $T/t.csv -o $T/o.csv --wind 20; cut "
                                                             "-d, -f8-11 $T/o.csv; " TREE_OF(
                                                                 ",crown_density_kg/m3\noak,20,250,14,4,2") GO
          "--wind 20; cut -d, "
          "-f7-10 $T/o.csv",
          CODE_OK,
          { "not read, though near to the name of an option: 'crown_density' (--crown-density), 'rain' "
            "(--rain)",
            "assessed,,incomplete,2.584\n", "assessed,,incomplete,2.5503\n" } },
        { TREE_OF(",edge_distance,stand_height\noak,20,250,14,4,20,22\noak,20,250,14,4,,") GO
          "--wind 20; cut -d, -f8-11 $T/o.csv; " GO
          "--wind 20 --spacing 3 --peak gales; cut -d, -f8-10 $T/o.csv",
          CODE_OK,
          { "assessed,\"edge_distance, stand_height: not used, because the row has no spacing; assessed as a "
            "tree",
            "\nassessed,,incomplete,2.584\nwf_status", "\nassessed,,incomplete\nassessed,,incomplete\n" } },
        /* mistakes of options, before any row */
        { TREE_OF(",soil,wind\noak,20,250,14,4,mineral,20\noak,20,250,14,4,,") "for o in '--samples 8' "
                                                                               "'--terrain 9' "
                                                                               "'--guy 9m' '--cavity foo' "
                                                                               "'--peak gales' "
                                                                               "; do " GO
                                                                               "--wind 20 $o 2>&1; echo $?; "
                                                                               "done; ls $T",
          CODE_OK,
          { "windfirm: 8 samples: 0, none, or 20 to 4096\n2\nwindfirm: unknown terrain category '9'",
            "\n2\nwindfirm: --guy: '9m...': a guy is HEIGHT:DISTANCE",
            "\n2\nwindfirm: --cavity: foo: cannot be read",
            "--peak gales needs the spacing of the stand: --spacing, or a column spacing\n2\nt.csv\n" } },
        { TREE_OF("\noak,20,250,14,4") GO "--wind 20 --peak gales --lang zh 2>&1; echo $?; ls $T",
          CODE_OK,
          { "需要林分的株距", "2\nt.csv\n" } },
        { TREE_OF(",spacing\noak,20,250,14,4,\noak,20,250,14,4,3") GO "--wind 20 --peak gales; echo $?",
          CODE_OK,
          { "0\n" } },
        /* names are of species, not of files; the header again */
        { TREE_OF("\n" CELLS "\nred oak,20,250,14,4") GO
          "--wind 20; cut -d, -f6,7 $T/o.csv; grep -c 'such file' "
          "$T/o.csv; :",
          CODE_OK,
          { "mistake,line 2: the row is the header again\nmistake,species: red oak: no shipped species "
            "table "
            "of that name; did you mean 'oak' (Quercus robur)?\n0\n" } },
        /* what a run left that was ended before the head was written is begun anew without a word */
        { TREE_OF(
              "\noak,20,250,14,4") ": >$T/o.csv.partial; echo y >$T/o.csv.partial.run; $W assess $T/t.csv -o "
                                   "$T/o.csv --wind 20 2>&1 | grep -c anew; ls $T",
          CODE_OK,
          { "0\no.csv\nt.csv\n" } },
    };
    CHECK(rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(own_winds), cmocka_unit_test(said_once) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
