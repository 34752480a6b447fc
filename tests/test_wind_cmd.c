/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Winds on the command line: grades, averaging times, measured profiles, directions, gusts, streams; bad
 * input. */
#include "close.h"
#include "shell.h"

#define PROFILE "printf 'height_m,speed_ms\\n2,3\\n5,4\\n10,5\\n' >$T/p.csv; "
#define ROSE                                                                                                 \
    "{ echo direction_deg,frequency,weibull_scale_ms,weibull_shape; for d in 0 45 90 135 180 225 270 315; "  \
    "do\n"                                                                                                   \
    "echo $d,1,9,1.5; done; } >$T/r.csv; "
#define POINTS "printf 'x_m,y_m,z_m\\n0,0,5\\n0,2,5\\n1,0,12\\n' >$T/x.csv; "
#define QUIET "--no-report -o $T/out "

static void test_speeds(void **state)
{
    (void)state;
    static const struct row rows[] = {
        /* 37.1 m/s over 2 min, divided by 1.12 (Harper et al. 2010, in-land): 33.1 m/s */
        { "$W analyze oak $M " QUIET "--wind cma:typhoon",
          CODE_OK,
          { "averaged over 2 min at 10 m", "37.1 m/s taken as 33.1 m/s over 10 min by the law 'in-land'",
            "33.12" } },
        { "$W series oak $M " QUIET "--no-vtk --duration 1 --wind beaufort:8",
          CODE_OK,
          { "taken as 19.0", "19" } },
        { "$W explain oak $M -o $T/out --no-report --wind hko:typhoon", CODE_OK, { "taken as 37.2" } },
        { "$W shelter $M -s oak -o $T/out --no-plots --no-motion --slabs 4 --wind beaufort:9",
          CODE_OK,
          { "22.6" } },
        /* sqrt(1 + 7 / ln(10 / 0.05)) = 1.5236 */
        { "$W analyze oak $M " QUIET "--wind 36 --averaging-time 3; grep winds_said $T/out/results.json",
          CODE_OK,
          { "3-s gusts of 36 m/s at 10 m over terrain II (10-min means of 23.63 m/s: times 0.6564",
            "\"winds_said\": \"wind given" } },
        { "$W series oak $M " QUIET "--no-vtk --duration 1 --wind 'gust:72 km/h'",
          CODE_OK,
          { "gusts of 20 m/s", "13.1" } },
        { "$W explain oak $M -o $T/out --no-report --wind gust:36 --terrain III --wind-at site",
          CODE_OK,
          { "over terrain III (10-min means of 20.8 m/s" } },
        { "$W analyze oak $M " QUIET "--wind gust:36 --averaging-time 3", CODE_INPUT, { "given twice" } },
        { "$W analyze oak $M " QUIET "--wind gust:36 --gust-factor 0.9",
          CODE_INPUT,
          { "0.9 is outside 1..4" } },
        { "$W analyze oak $M " QUIET "--wind gust:36 --gust-factor 1.8",
          CODE_OK,
          { "10-min means of 20 m/s" } },
        /* Durst: (1.277 + 0.296 tanh(0.9 log10(45/600))) / (1.277 + 0.296 tanh(0.9 log10(45/3))) = 0.6957 */
        { "$W analyze oak $M " QUIET
          "--wind 30,40 --averaging-time 3 --averaging durst; grep winds_said $T/out/results.json",
          CODE_OK,
          { "3-s gusts of 30, 40 m/s", "times 0.6957", "27.83", "by the law 'durst'" } },
        { "$W analyze oak $M " QUIET "--wind 20 --averaging-time '1 h' --averaging in-land",
          CODE_OK,
          { "times 1.08, as the strongest 10-min mean", "21.60" } },
        { "$W analyze oak $M " QUIET "--wind 20 --averaging-time 90 --averaging in-land",
          CODE_INPUT,
          { "--averaging-time: in-land: averaging times of 90 s and 600 s" } },
        { "$W analyze oak $M " QUIET "--wind 20 --averaging drst", CODE_INPUT, { "did you mean 'durst'?" } },
        { "$W series oak $M " QUIET "--wind 10,20", CODE_INPUT, { "one wind speed is taken" } },
        { "$W wind kaimal -o $T/out --wind nan", CODE_INPUT, { "--wind: 'nan' is not a speed" } },
        { "$W shelter $M -s oak --wind beaufort:19", CODE_INPUT, { "unknown grade '19'" } },
        /* twice as exposed: half the critical wind */
        { "$W analyze moso_bamboo $M " QUIET
          "--wind 5 --speed-up 2 -q; $W analyze moso_bamboo $M -o $T/two --no-report "
          "--wind 10 -q; cut -d, -f5,12 $T/out/tables/summary.csv | tail -1; cut -d, -f5,12 "
          "$T/two/tables/summary.csv "
          "| tail -1",
          CODE_OK,
          { "" } },
    };
    CHECK(rows);
    char *first = strtok(output, "\n"), *second = strtok(NULL, "\n"); /* the last row's: two equal lines */
    assert_non_null(second);
    assert_string_equal(first, second);
}

/* Terrain, site and design winds: what is said in the first lines, and what is refused. */
static void test_site(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W analyze oak $M " QUIET "--wind 10",
          CODE_OK,
          { "at 10 m over terrain II; their 3-s gusts are 1.524 times", "Site: terrain II, assumed",
            "wind profile power", "gust" } },
        { "$W analyze oak $M " QUIET
          "--wind 30 --site suburb --search-to 100; grep -A2 '\"carried\"' $T/out/results.json",
          CODE_OK,
          { "Site: terrain III (obstacles", "wind profile terrain", "is 0.7503 times the wind named",
            "0.750" } },
        { "$W analyze oak $M " QUIET "--wind 30 --terrain III --wind-at site",
          CODE_OK,
          { "over terrain III; their 3-s gusts are 1.731 times" } },
        { "for c in 'explain --no-report' 'series --no-vtk --no-report --duration 1'; do set -- $c; c=$1; "
          "shift\n"
          "$W $c oak $M -o $T/out $* --design en1991 --basic-wind 25 --terrain III || exit; done",
          CODE_OK,
          { "basic wind 25 m/s", "10-min mean 18.88 m/s and gust 32.68 m/s",
            "From run 1: wind profile terrain" } },
        { "$W analyze oak $M " QUIET "--design arborist",
          CODE_OK,
          { "gust 33 m/s at the tree", "wind profile uniform", "Peak load: gust" } },
        { "$W analyze oak $M " QUIET "--design gb50009 --basic-pressure '0.45 kN/m2' --terrain C",
          CODE_OK,
          { "basic wind 26.83 m/s", "Peak load: gb50009, terrain C", "air 1.250" } },
        { "$W wind list", CODE_OK, { "gb50009    B            II", "-24%", "arborist: ", "regional gust" } },
        { "$W analyze oak $M " QUIET "--design en1991 --terrain III",
          CODE_INPUT,
          { "needs its basic wind" } },
        { "$W analyze oak $M " QUIET "--design en1991 --basic-wind 25 --return-period 1",
          CODE_INPUT,
          { "longer than 1 year" } },
        { "$W analyze oak $M " QUIET "--design en1991 --basic-wind 25 --wind 10",
          CODE_INPUT,
          { "no effect beside a design wind" } },
        { "$W analyze oak $M " QUIET "--wind 10 --basic-wind 25", CODE_INPUT, { "without a design wind" } },
        { "$W analyze oak $M " QUIET "--wind 10 --terrain V",
          CODE_INPUT,
          { "there are 0, I, II, III and IV" } },
        { "$W analyze oak $M " QUIET "--wind 10 --wind-at site",
          CODE_INPUT,
          { "without --terrain or --site" } },
        { "$W analyze oak $M " QUIET "--wind 10 --profile code", CODE_INPUT, { "of a design code" } },
        { "$W analyze oak --tree docs/examples/scan.csv " QUIET "--wind 10 --search-to 12",
          CODE_OK,
          { "[site-assumed]", "instead of", "--site says where it stands" } },
        { "$W analyze oak --tree docs/examples/scan.csv " QUIET
          "--wind 10 --search-to 12 --site open 2>&1 | grep -c site-assumed; true",
          CODE_OK,
          { "0" } },
        { "$W terrain --size 6 --relief 60 --smoothness 0.2 --cell 10 -o $T/out --no-plots; grep -c "
          "'[^0-9]-[0-9.]*$' "
          "$T/out/tables/terrain.csv; true",
          CODE_OK,
          { "[speed-up-outside]", "they have no wind factor", "\n0\n" } },
    };
    CHECK(rows);
}

static void test_profile(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { PROFILE "$W analyze oak $M " QUIET "--wind 10 --profile-file $T/p.csv; grep -A1 -e profile_file -e "
                  "'\"role\": \"profile\"' $T/out/results.json",
          CODE_OK,
          { "wind profile measured", "the measured profile ends at 10 m", "p.csv",
            "\"role\": \"profile\"" } },
        { PROFILE
          "for c in 'explain --no-report' 'series --no-vtk --no-report --duration 1'; do set -- $c; c=$1; "
          "shift\n"
          "$W $c oak $M -o $T/out $* --profile-file $T/p.csv || exit; done; cat $T/out/tables/runs.csv",
          CODE_OK,
          { "profile ends at 10 m", "measured,", "p.csv" } },
        { PROFILE "$W shelter $M -s oak -o $T/out --no-plots --no-motion --slabs 4 --profile-file $T/p.csv",
          CODE_OK,
          { "profile ends at 10 m" } },
        { "printf 'height_m,speed_ms\\n5,4\\n' >$T/p.csv; $W analyze oak $M " QUIET
          "--wind 10 --profile-file $T/p.csv",
          CODE_INPUT,
          { "at least two heights above the ground, 1 given" } },
        { "printf 'height_m,speed_ms\\n5,4\\n2,x\\n' >$T/p.csv; $W series oak $M " QUIET
          "--profile-file $T/p.csv",
          CODE_INPUT,
          { "p.csv:3:3: error: ", "speed_ms: 'x'" } },
        { "printf 'height_m,speed_ms\\n5,4\\n2,3\\n' >$T/p.csv; $W explain oak $M --profile-file $T/p.csv",
          CODE_INPUT,
          { "2 m is not above 5 m" } },
        { "$W analyze oak $M " QUIET "--wind 10 --profile measured",
          CODE_INPUT,
          { "needs a file of heights and speeds" } },
        { PROFILE "$W analyze oak $M " QUIET "--wind 10 --profile log --profile-file $T/p.csv",
          CODE_INPUT,
          { "is for the profile 'measured', not 'log'" } },
        { "$W series oak $M " QUIET "--no-vtk --duration 1 --profile canopy",
          CODE_INPUT,
          { "needs the canopy height" } },
        { PROFILE
          "PATH=$T $W analyze oak $M --wind 10 -o $T/out -q --profile-file $T/p.csv --directions 8 --lang "
          "en; grep "
          "-o -e 'as measured, 2 to 10 m' -e 'Wind from all around' -e '10-min means' -e 'from all 8 "
          "directions' "
          "$T/out/report.html",
          CODE_OK,
          { "as measured, 2 to 10 m", "Wind from all around", "10-min means", "from all 8 directions" } },
    };
    CHECK(rows);
}

static void test_directions(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W analyze oak $M " QUIET
          "--wind 10,20 --directions 8; wc -l <$T/out/tables/directions.csv; grep -c "
          "'\"from\"' $T/out/results.json",
          CODE_OK,
          { "clockwise from north; north is +y, east +x", "     315", "17\n", "8\n" } },
        { ROSE "$W analyze oak $M " QUIET
               "--wind 10 --climate $T/r.csv --north 30; tail -1 $T/out/tables/directions.csv",
          CODE_OK,
          { "north is 30 deg clockwise from +y", "hours a year", "by the law 'durst'", "0.125,9,1.5," } },
        { "$W analyze oak $M " QUIET "--wind 10 --directions 8 -q; $W analyze oak $M " QUIET
          "--wind 10; ls $T/out/tables",
          CODE_OK,
          { "segments.csv" } },
        { ROSE "$W analyze oak $M " QUIET "--wind 10 --climate $T/r.csv --directions 12",
          CODE_INPUT,
          { "has 8; leave --directions out" } },
        { ROSE "sed -i '$d' $T/r.csv; $W compare oak poplar $M " QUIET "--wind 10 --climate $T/r.csv",
          CODE_INPUT,
          { "7 directions; a rose has 8, 12 or 16" } },
        { ROSE "sed -i 's/45,1,/46,-1,/' $T/r.csv; $W analyze oak $M " QUIET "--wind 10 --climate $T/r.csv",
          CODE_INPUT,
          { "r.csv:3:4: error: frequency" } },
        { "$W analyze oak $M " QUIET "--wind 10 --directions 7",
          CODE_INPUT,
          { "'7' is none of 8, 12, 16, 36" } },
    };
    CHECK(rows);
    /* the table of an earlier run in the same folder is gone */
    assert_int_equal(shell(rows[2].command), CODE_OK);
    assert_null(strstr(output, "directions.csv"));
}

static void test_gusts(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W series oak $M " QUIET "--no-vtk --duration 5 --gust von-karman --set length=80,share-up=0.4; "
          "cat $T/out/tables/runs.csv",
          CODE_OK,
          { ",3,\"intensity=0.2;length=80;share-across=0.75;share-up=0.4;" } },
        { "$W series oak $M " QUIET "--no-vtk --duration 5 --gust eog --set start=1,duration=4",
          CODE_OK,
          { "oak" } },
        { "$W series oak $M " QUIET "--no-vtk --duration 2 --gust kaimal --solver deflect",
          CODE_OK,
          { "along-wind-only", "in one direction" } },
        { "$W series oak $M " QUIET "--no-vtk --duration 2 --gust kaimal --shelter wake",
          CODE_OK,
          { "along-wind-only", "made for one direction" } },
        { "$W series oak $M " QUIET "--gust kaimal --intensity 5", CODE_INPUT, { "5 is outside 0..1" } },
        { "$W series oak $M " QUIET "--gust kaimal --set lenght=3",
          CODE_INPUT,
          { "unknown parameter 'lenght'" } },
        { "$W series oak $M " QUIET "--gust perlin --set octaves=3.5",
          CODE_INPUT,
          { "octaves = 3.5 is not a whole number (number of octaves)" } },
        { "$W series oak $M " QUIET "--gust cosine --components 3",
          CODE_INPUT,
          { "along its mean direction only" } },
        { "$W series oak $M " QUIET "--gust record", CODE_INPUT, { "needs the file of an anemometer" } },
        { "$W series oak $M " QUIET "--gust cosine --file x.csv",
          CODE_INPUT,
          { "--file: has no effect with the gust model 'cosine'" } },
        { "{ echo t_s,u_ms; i=0; while [ $i -lt 60 ]; do echo $i,$((i % 7 + 1)); i=$((i + 1)); done; } "
          ">$T/a.csv\n"
          "$W series oak $M " QUIET
          "--no-vtk --duration 30 --step 1 --gust record --file $T/a.csv --columns t_s,u_ms; "
          "grep -c a.csv $T/out/tables/runs.csv",
          CODE_OK,
          { "30        3", "1\n" } },
        { "{ echo t_s,u_ms; i=0; while [ $i -lt 60 ]; do echo $i,calm; i=$((i + 1)); done; } >$T/a.csv\n"
          "$W series oak $M " QUIET "--gust record --file $T/a.csv --columns t_s,u_ms",
          CODE_INPUT,
          { "60 of 60 rows", "'calm'" } },
        { "cat >$T/runs.yaml <<'E'\nruns_of: mine\ntitle: Mine\nruns:\n  - name: a\n    species: oak\n    "
          "model: "
          "models/culm.yaml\n    wind: 10 m/s\n    gust: perlin\n    set: octaves=3\n    duration: 2 s\n    "
          "profile: "
          "log\n    roughness: 5 cm\nE\n$W papers $T/runs.yaml " QUIET "--no-vtk; cat $T/out/tables/runs.csv",
          CODE_OK,
          { "octaves=3", ",log," } },
    };
    CHECK(rows);
}

static void test_stream(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { POINTS "$W wind kaimal --components 3 --points-file $T/x.csv --duration 100 --stream $T/s.npy; wc "
                 "-c <$T/s.npy; "
                 "head -c 100 $T/s.npy | tail -c 90",
          CODE_OK,
          { "3 points, 1000 steps", "36128", "'shape': (1000, 3, 3)" } }, /* 128 + 4 * 1000 * 3 * 3 */
        { "$W wind kaimal --points 3 --spacing 3 --duration 100 -o $T/out --no-plots -q; $W wind kaimal "
          "--points 3 "
          "--spacing 3 --duration 100 --stream $T/s.csv -q; head -1 $T/s.csv; awk -F, 'NR == FNR { a[NR] = "
          "$3; next } "
          "FNR > 1 && (a[FNR] - $3) ^ 2 > 1e-8 { bad++ } END { print NR / 2, bad + 0 }' "
          "$T/out/tables/series.csv "
          "$T/s.csv",
          CODE_OK,
          { "t_s,u1_m_s,u2_m_s,u3_m_s", "1001 0" } },
        { "$W wind kaimal --points 300", CODE_INPUT, { "--stream writes any number" } },
        { POINTS "$W wind kaimal --points 3 --points-file $T/x.csv", CODE_INPUT, { "not both" } },
        { POINTS "echo 0,0,-1 >>$T/x.csv; echo a,0,1 >>$T/x.csv; $W wind kaimal --points-file $T/x.csv "
                 "--stream $T/s.npy",
          CODE_INPUT,
          { "x.csv:5:5: error: z_m", "x.csv:6:1: error: x_m" } },
        { POINTS "$W wind kaimal --points-file $T/x.csv --duration 100 --stream /dev/null/s.npy",
          CODE_RUN,
          { "s.npy" } },
    };
    CHECK(rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(test_speeds),  cmocka_unit_test(test_site),
                                        cmocka_unit_test(test_profile), cmocka_unit_test(test_directions),
                                        cmocka_unit_test(test_gusts),   cmocka_unit_test(test_stream) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
