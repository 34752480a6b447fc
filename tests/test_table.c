/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Files as loggers, spreadsheets and people write them: the same numbers in other units, separators, orders,
 * times and encodings give the same answer. The samples of tests/data/public are made up. */
#include "base/clock.h"
#include "base/column.h"
#include "base/text.h"
#include "close.h"
#include "scratch.h"
#include "shell.h"
#include <math.h>

#define P "tests/data/public/"
#define RECORD(file, columns) "$W wind record --no-plots -o $T/out --file " file " --columns " columns
#define MADE(how, columns) how " >$T/r\n" RECORD("$T/r", columns)
#define MEAN "mean 8.139 m/s"

static void units_are_those_of_the_names(void **unused)
{
    (void)unused;
    static const struct row rows[] = {
        { RECORD(P "wind_kmh.csv", "t_s,u_kmh"), CODE_OK, { MEAN, "10.483 m/s" } },
        { MADE("sed 's/t_s,u_kmh/t_s,u (km\\/h)/' " P "wind_kmh.csv", "'t_s,u (km/h)'"), CODE_OK, { MEAN } },
        { MADE("awk -F, 'NR==1{print \"t_s;U [kn]\";next}{printf \"%s;%.6f\\n\",$1,$2/1.852}' " P
               "wind_kmh.csv",
               "'t_s,U [kn]'"),
          CODE_OK,
          { MEAN } },
        { MADE("awk -F, 'NR==1{print \"u_mph\\tt_min\";next}{printf \"%.6f\\t%.8f\\n\",$2/1.609344,$1/60}' " P
               "wind_kmh.csv",
               "t_min,u_mph"),
          CODE_OK,
          { MEAN } },
        { MADE("sed 's/u_kmh/wind/' " P "wind_kmh.csv", "t_s,wind"),
          CODE_OK,
          { "mean 29.30", "[unit-assumed]", "column 'wind' names no unit and is taken to be in m/s" } },
        { MADE("sed 's/t_s/time/;s/u_ms/speed_ms/' " P "wind_2hz_one_minute.csv", "time,speed_ms"),
          CODE_OK,
          { "120 steps of 0.5 s", "column 'time' names no unit and is taken to be in s" } },
        { MADE("sed 's/u_kmh/u (V)/' " P "wind_kmh.csv", "'t_s,u (V)'"),
          CODE_INPUT,
          { "'V' is not a unit of a speed" } },
        { MADE("sed 's/u_kmh/u_bft/' " P "wind_kmh.csv", "t_s,u_bft"), CODE_INPUT, { "Beaufort" } },
        { RECORD(P "wind_2hz_one_minute.csv", "t_s,u_ms") " --duration 30",
          CODE_OK,
          { "60 steps of 0.5 s" } },
        { RECORD(P "wind_2hz_one_minute.csv", "-,u_ms"), CODE_INPUT, { "needs its rate", "--rate" } },
        { RECORD(P "wind_2hz_one_minute.csv", "-,u_ms") " --rate 2", CODE_OK, { "120 steps of 0.5 s" } },
        { RECORD(P "wind_2hz_one_minute.csv", ",u_ms") " --step 0.5", CODE_OK, { "120 steps of 0.5 s" } },
        { RECORD(P "wind_2hz_one_minute.csv", "t_s,u_ms") " --rate 2",
          CODE_INPUT,
          { "without a time column" } },
    };
    CHECK(rows);
}

static void separators_times_and_heads(void **unused)
{
    (void)unused;
    static const struct row rows[] = {
        { RECORD(P "wind_decimal_comma.csv", "t_s,u_ms"), CODE_OK, { MEAN } },
        { MADE("tr ';' '\\t' <" P "wind_decimal_comma.csv", "t_s,u_ms"), CODE_OK, { MEAN } },
        { MADE("awk -F';' '{print $2\";\"$1}' " P "wind_decimal_comma.csv", "t_s,u_ms"), CODE_OK, { MEAN } },
        { MADE("sed '5s/,/./' " P "wind_decimal_comma.csv", "t_s,u_ms"),
          CODE_INPUT,
          { ":5:1:", "are mixed" } },
        { RECORD(P "wind_timestamps.csv", "time,u_ms"), CODE_OK, { MEAN, "steps of 0.5 s" } },
        { MADE("sed 's/T/ /;s/Z//' " P "wind_timestamps.csv", "time,u_ms"), CODE_OK, { MEAN } },
        { MADE("sed 's/Z/+01:00/' " P "wind_timestamps.csv", "time,u_ms"), CODE_OK, { MEAN } },
        { MADE("sed 's/2024-01-05T/05.01.2024 /;s/Z//' " P "wind_timestamps.csv", "time,u_ms"),
          CODE_OK,
          { MEAN } },
        { MADE("sed 's/2024-01-05T//;s/Z//' " P "wind_timestamps.csv", "time,u_ms"), CODE_OK, { MEAN } },
        { MADE("sed 's/2024-01-05T12:0/23:59:/;s/Z//' " P "wind_timestamps.csv |"
               "awk -F, 'NR==1{print;next}{t=86385+(NR-2)/2;if(t>=86400)t-=86400;"
               "printf \"%02d:%02d:%04.1f,%s\\n\",t/3600,t%3600/60,t%60,$2}'",
               "time,u_ms"),
          CODE_OK,
          { MEAN, "120 steps of 0.5 s" } },
        { RECORD(P "wind_logger_toa5.dat", "TIMESTAMP,Ux,Uy,Uz"),
          CODE_OK,
          { "120 rows, 120 steps of 0.5 s; 1 rows with unreadable", "mean 8.140 m/s towards 36.9 deg" } },
        { MADE("sed '3s|m/s|km/hr|g' " P "wind_logger_toa5.dat", "TIMESTAMP,Ux,Uy,Uz"),
          CODE_OK,
          { "mean 2.261 m/s" } },
        { MADE("sed '3s|m/s|knots|g;s/$/\\r/' " P "wind_logger_toa5.dat", "TIMESTAMP,Uy,Ux,Uz"),
          CODE_OK,
          { "mean 4.187 m/s towards 53.1 deg" } },
        { MADE("sed '3s|m/s|V|g' " P "wind_logger_toa5.dat", "TIMESTAMP,Ux,Uy,Uz"),
          CODE_INPUT,
          { ":2:", "'V' is not a unit of a speed" } },
        { MADE("{ printf 'LS1\\n05\\\\01\\\\24\\n12:00:00\\n';"
               "for k in A B C D E F G H I J; do echo $k=1; done; echo 2.5; }",
               "t_s,u_ms"),
          CODE_INPUT,
          { "LineScale 3 is not read" } },
    };
    CHECK(rows);
}

static void marks_are_told_from_peaks(void **unused)
{
    (void)unused;
#define PEAKS "sed '50s/,.*/,99.0/;80s/,.*/,99.9/' " P "wind_kmh.csv"
    static const struct row rows[] = {
        /* a straight line over the three gaps: (956.83 + 7.6067 + 7.5733 + 7.615) / 120 */
        { RECORD(P "wind_missing_99.csv", "t_s,u_ms"),
          CODE_OK,
          { "3 rows with unreadable cells", "mean 8.164 m/s", "10.480 m/s", "[missing-marks]" } },
        { MADE("sed 's/99.0/-99.9/' " P "wind_missing_99.csv", "t_s,u_ms"), CODE_OK, { "mean 8.164 m/s" } },
        { MADE("sed 's/99.0/999/;s/u_ms/u_ms,v_ms/;2,$s/$/,0/' " P "wind_missing_99.csv", "t_s,u_ms,v_ms"),
          CODE_OK,
          { "mean 8.164 m/s" } },
        { MADE("sed '1i# missing: 99, 7777' " P "wind_missing_99.csv", "t_s,u_ms"),
          CODE_OK,
          { "mean 8.164 m/s" } },
        { MADE("sed '43,95s/99.0/8.0/' " P "wind_missing_99.csv", "t_s,u_ms"),
          CODE_INPUT,
          { "r:42: error: column 'u_ms': 99 (99 m/s)", "--missing 99", "--missing none" } },
        { MADE("sed '43,95s/99.0/8.0/' " P "wind_missing_99.csv", "t_s,u_ms") " --missing 99",
          CODE_OK,
          { "1 rows with unreadable" } },
        { MADE("sed '43,95s/99.0/8.0/' " P "wind_missing_99.csv", "t_s,u_ms") " --missing none",
          CODE_OK,
          { "0 rows with unreadable", "99.000 m/s" } },
        { MADE(PEAKS, "t_s,u_kmh"), CODE_OK, { "0 rows with unreadable", "27.750 m/s" } },
        { MADE("sed '50s/,.*/,99.9/' " P "wind_kmh.csv", "t_s,u_kmh"),
          CODE_INPUT,
          { "r:50: error:", "--missing none" } },
        { MADE("sed '50s/,.*/,99.9/;80s/,.*/,99.9/' " P "wind_kmh.csv", "t_s,u_kmh") " --missing none",
          CODE_OK,
          { "27.750 m/s" } },
        { MADE("sed 's/99.0/x/' " P "wind_missing_99.csv", "t_s,u_ms") " --missing x",
          CODE_INPUT,
          { "'x'", "'none'" } },
        { MADE("sed '20,33d' " P "wind_2hz_one_minute.csv", "t_s,u_ms"), CODE_INPUT, { "14 of 120 steps" } },
        { MADE("sed '20,23s/,.*/,NA/' " P "wind_2hz_one_minute.csv", "t_s,u_ms"), CODE_OK, { "longest 4" } },
    };
    CHECK(rows);
}

static void trees_by_hand(void **unused)
{
    (void)unused;
#define INFO(how) how " >$T/r.csv\n$W tree info $T/r.csv"
#define GIRTH "base diameter       0.2400 m"
    static const struct row rows[] = {
        { "$W tree info " P "girth.csv", CODE_OK, { GIRTH, "0.15325 m3" } },
        { INFO("printf 'id;girth (in);parent;length_ft\\n1;29,685039;;6,561680\\n2;24,724409;1;6,561680\\n'"),
          CODE_OK,
          { GIRTH, "0.1532" } },
        { INFO("printf 'id\\tparent\\tdiameter_mm\\tlength [m]\\n1\\tNA\\t240\\t2\\n2\\t1\\t199.9\\t2\\n'"),
          CODE_OK,
          { GIRTH } },
        { INFO("printf 'length_yd,circumference_dm,parent,id\\n2.187227,7.54,-,1\\n2.187227,6.28,1,2\\n'"),
          CODE_OK,
          { GIRTH } },
        { "$W tree info " P "utf16.csv", CODE_OK, { "height              4.000 m", "0.15331 m3" } },
        { INFO("iconv -f UTF-16 -t UTF-8 " P "utf16.csv"), CODE_OK, { "0.15331 m3" } },
        { INFO("iconv -f UTF-16 -t UTF-16BE " P "utf16.csv"), CODE_OK, { "0.15331 m3" } },
        { INFO("{ iconv -f UTF-16 -t LATIN1 " P "utf16.csv | tr -d '\\r' | "
               "awk 'NR==1{printf \"%s,art\\n\",$0;next}{printf \"%s,L\\344rche\\n\",$0}'; }"),
          CODE_OK,
          { "0.15331 m3", "Windows-1252" } },
        { INFO("printf 'id,parent,diameter_cm,length_m\\n1,,20,N/A\\n'"), CODE_INPUT, { "" } },
    };
    CHECK(rows);
}

static void pull_tests(void **unused)
{
    (void)unused;
#define FIT(how)                                                                                             \
    "cp " P "pull_* " P "sample_pine.yaml $T; cd $T; chmod u+w *; W=$OLDPWD/$W\n" how                        \
    "\n$W fit p.yaml -o out --no-report --no-profile --no-rival"
#define E "level0.youngs_modulus"
#define RIGHT "7.238 to 7.31 "
#define DATES "sed 's/pull_day_first.csv/d.csv/' pull_day_first.yaml >p.yaml; "
    static const struct row rows[] = {
        { FIT("cp pull_sections.yaml p.yaml"), CODE_OK, { E, "7.274 GPa", RIGHT } },
        { FIT("sed '/pull:/s/kN/N/;s/pull_sections.txt/s.txt/' pull_sections.yaml >p.yaml;"
              "awk -F'\\t' -v OFS='\\t' '/^[0-9]+\\t/{sub(\",\",\".\",$6);$6=$6*1000}{print}' "
              "pull_sections.txt >s.txt"),
          CODE_OK,
          { RIGHT } },
        { FIT("sed 's/pull_sections.txt/s.txt/' pull_sections.yaml >p.yaml;"
              "tr '\\t,' ';.' <pull_sections.txt | sed 's/\\[Data\\]/[data]/' >s.txt"),
          CODE_OK,
          { RIGHT } },
        { FIT("sed 's/pull_sections.txt/s.txt/' pull_sections.yaml >p.yaml;"
              "iconv -f UTF-8 -t UTF-16 pull_sections.txt >s.txt"),
          CODE_OK,
          { RIGHT } },
        { FIT("iconv -f UTF-8 -t UTF-16 pull_day_first.yaml >p.yaml"), CODE_OK, { E, RIGHT } },
        { FIT("cp pull_day_first.yaml p.yaml"), CODE_OK, { E, RIGHT } },
        { FIT(DATES "sed 's|05/01/2024|05.01.2024|' pull_day_first.csv >d.csv"), CODE_OK, { RIGHT } },
        { FIT(DATES "sed 's|05/01/2024|01/25/2024|' pull_day_first.csv >d.csv"), CODE_OK, { RIGHT } },
        { FIT(DATES "sed 's|05/01/2024 |2024-01-05T|;s/force_N/F (kp)/;1!s/,100,/,100,/' pull_day_first.csv |"
                    "awk -F, -v OFS=, 'NR>1{$2=sprintf(\"%.9f\",$2/9.80665)}{print}' >d.csv;"
                    "sed -i 's/column: force_N/column: \"F (kp)\"/' p.yaml"),
          CODE_OK,
          { RIGHT } },
        { FIT(DATES "sed '7,$s|05/01|06/01|' pull_day_first.csv >d.csv"),
          CODE_INPUT,
          { "d.csv:2:1: error:", "dates: day-first", "dates: month-first" } },
        { FIT(DATES "sed '7,$s|05/01|06/01|' pull_day_first.csv >d.csv;"
                    "sed -i 's/    time: time/&\\n    dates: day-first/' p.yaml"),
          CODE_OK,
          { RIGHT } },
        { FIT(DATES "sed 's/    time: time/    until: 20 s/' -i p.yaml; cp pull_day_first.csv d.csv"),
          CODE_INPUT,
          { "needs the time of the rows", "rate" } },
        { FIT(DATES "sed 's/    time: time/    until: 20 s\\n    rate: 1 Hz/' -i p.yaml; cp "
                    "pull_day_first.csv d.csv"),
          CODE_OK,
          { RIGHT } },
    };
    CHECK(rows);
}

static void free_sway_has_a_rate(void **unused)
{
    (void)unused;
#define SWAY(key)                                                                                            \
    FIT("{ sed '/^tests:/,$d' pull_day_first.yaml; echo 'tests:'; echo '  - name: sway'; echo '    data: "   \
        "s.csv'; " key                                                                                       \
        "echo '    sway: {column: tilt}'; sed -n '/^free:/,$p' pull_day_first.yaml; } >p.yaml\n"             \
        "awk 'BEGIN{print \"t_s,tilt\"; for(i=0;i<400;i++){t=i/20; printf "                                  \
        "\"%.2f,%.6f\\n\",t,exp(-0.1*t)*cos(4*t)}}' >s.csv")
    static const struct row rows[] = {
        { SWAY(""), CODE_INPUT, { "the frequency of free sway needs the time of the rows", "rate: 20 Hz" } },
        { SWAY("echo '    time: t_s'; ") " && cat out/tables/*.csv", CODE_OK, { E, "0.636" } },
        { SWAY("echo '    rate: 20 Hz'; ") " && cat out/tables/*.csv", CODE_OK, { E, "0.636" } },
    };
    CHECK(rows);
}

static void other_encodings(void **unused)
{
    (void)unused;
    static const struct {
        const char *from;
        size_t size;
        const char *to; /* NULL: refused */
    } utf16[] = {
        { "\xFF\xFE"
          "a\0\xE4\0",
          6, "a\xC3\xA4" },
        { "\xFE\xFF\0a\x20\xAC", 6, "a\xE2\x82\xAC" },
        { "a\0b\0", 4, "ab" },
        { "\0a\0b", 4, "ab" },
        { "\xFF\xFE\x3D\xD8\x00\xDE", 6, "\xF0\x9F\x98\x80" },
        { "\xFF\xFE\x3D\xD8", 4, NULL },
        { "\xFF\xFE\x00\xDE", 4, NULL },
        { "\xFF\xFE"
          "a",
          3, NULL },
        { "\xFF\xFE\0\0", 4, NULL },
    };
    char to[64];
    for (size_t i = 0; i < sizeof utf16 / sizeof *utf16; i++) {
        enum wf_utf16 order = wf_utf16_order(utf16[i].from, utf16[i].size);
        assert_int_not_equal(order, WF_UTF16_NOT);
        size_t n = wf_utf16_to_utf8(utf16[i].from, utf16[i].size, order, to);
        assert_int_equal(n, utf16[i].to ? strlen(utf16[i].to) : (size_t)-1);
        if (utf16[i].to) assert_memory_equal(to, utf16[i].to, n);
    }
    assert_int_equal(wf_utf16_order("ab", 2), WF_UTF16_NOT);
    assert_int_equal(wf_cp1252_to_utf8("\x80\xE4\t", 3, to), 6);
    assert_memory_equal(to, "\xE2\x82\xAC\xC3\xA4\t", 6);
    assert_int_equal(wf_cp1252_to_utf8("\x81", 1, to), (size_t)-1);
    assert_int_equal(wf_cp1252_to_utf8("\x01", 1, to), (size_t)-1);
    assert_int_equal(wf_cp1252_to_utf8("\xC3\xA4", 2, to), (size_t)-1);
    for (const struct wf_csv_head *h = wf_csv_heads; h->name; h++)
        assert_true(h->source && h->is && (h->refused || h->section || h->before));
}

/* A column of times as a table, read and settled. */
static enum wf_status read_times(const char *cells, enum wf_dates dates, double *t, size_t *n,
                                 struct wf_err *e)
{
    char text[512];
    struct scratch s;
    struct wf_arena a = { 0 };
    struct wf_diag d = { .arena = &a };
    struct wf_csv c;
    struct wf_clock clock = { .dates = dates, .factor = 1 };
    snprintf(text, sizeof text, "time;x\n%s", cells);
    scratch_write(&s, text, strlen(text));
    enum wf_status status = wf_csv_open(&c, s.path, &a, &d, e);
    for (*n = 0; !status && wf_csv_next(&c); ++*n)
        if (!wf_clock_read(&clock, &c, 0, &t[*n])) t[*n] = NAN;
    if (!status) status = wf_clock_settle(&clock, "f", "so", t, *n, e);
    if (!status && d.errors) status = wf_fail(e, WF_EINPUT, "%s", d.first->text);
    wf_arena_free(&a);
    scratch_remove(&s);
    return status;
}

static void times_of_every_kind(void **unused)
{
    (void)unused;
    static const struct {
        const char *cells;
        double step;       /* between the first two rows; NAN: refused */
        const char *words; /* of the refusal */
        enum wf_dates dates;
    } all[] = {
        { "0;1\n0.25;1\n", 0.25, NULL, 0 },
        { "0;1\n0,25;1\n", 0.25, NULL, 0 },
        { "2024-02-28T23:59:59.5Z;1\n2024-02-29T00:00:00Z;1\n", 0.5, NULL, 0 },
        { "2024-01-05T00:30:00+01:00;1\n2024-01-04T23:30:01Z;1\n", 1, NULL, 0 },
        { "2024-01-05 12:00;1\n2024-01-05 12:01;1\n", 60, NULL, 0 },
        { "2024/01/05 12:00:00;1\n2024/01/06 12:00:00;1\n", 86400, NULL, 0 },
        { "05.01.2024 12:00:00,5;1\n06.01.2024 12:00:00,5;1\n", 86400, NULL, 0 },
        { "05.01.24 12:00:00;1\n05.01.24 12:00:01;1\n", 1, NULL, 0 },
        { "05/01/2024 11:59:59 AM;1\n05/01/2024 12:00:00 PM;1\n", 1, NULL, 0 },
        { "05/01/2024 12:00:00 AM;1\n05/01/2024 01:00:00 AM;1\n", 3600, NULL, 0 },
        { "12/01/2024 00:00;1\n13/01/2024 00:00;1\n", 86400, NULL, 0 },
        { "01/12/2024 00:00;1\n01/13/2024 00:00;1\n", 86400, NULL, 0 },
        { "05/01/2024 00:00;1\n06/01/2024 00:00;1\n", NAN, "say so", 0 },
        { "05/01/2024 00:00;1\n06/01/2024 00:00;1\n", 86400, NULL, WF_DATES_DAY_FIRST },
        { "05/01/2024 00:00;1\n06/01/2024 00:00;1\n", 31 * 86400.0, NULL, WF_DATES_MONTH_FIRST },
        { "13/01/2024 00:00;1\n13/02/2024 00:00;1\n", NAN, "or not as is said", WF_DATES_MONTH_FIRST },
        { "13/01/2024 00:00;1\n01/13/2024 00:00;1\n", NAN, "day first in some rows", 0 },
        { "23:59:59.5;1\n0:00:00.5;1\n", 1, NULL, 0 },
        { "12:00;1\n12:01;1\n", 60, NULL, 0 },
        { "12:00:01;1\n12:00:00;1\n", -1, NULL, 0 },
        { "12:00:01;1\n7;1\n", NAN, "not a time of day", 0 },
        { "7;1\n12:00:01;1\n", NAN, "not a number", 0 },
        { "30/02/2024 00:00;1\n", NAN, "not a number or a time", 0 },
        { "2023-02-29T00:00:00;1\n", NAN, "not a number or a time", 0 },
        { "24:00:00;1\n", NAN, "not a number or a time", 0 },
        { "24-01-05 00:00:00;1\n", NAN, "not a number or a time", 0 },
        { "2024-01-05T12:00:00X;1\n", NAN, "not a number or a time", 0 },
    };
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        double t[8];
        size_t n;
        struct wf_err e = { 0 };
        enum wf_status status = read_times(all[i].cells, all[i].dates, t, &n, &e);
        if (isnan(all[i].step)) {
            if (status != WF_EINPUT || !strstr(e.text, all[i].words)) fail_msg("%zu: %s", i, e.text);
        } else {
            if (status) fail_msg("%zu: %s", i, e.text);
            if (fabs(t[1] - t[0] - all[i].step) > 1e-9) fail_msg("%zu: %.12g s", i, t[1] - t[0]);
        }
    }
}

static void units_in_names(void **unused)
{
    (void)unused;
    static const struct {
        const char *name;
        enum wf_dimension dimension;
        double factor; /* 0: none */
        size_t stem;
    } all[] = {
        { "u_kmh", WF_DIM_SPEED, 1 / 3.6, 1 },
        { "U_KMH", WF_DIM_SPEED, 1 / 3.6, 1 },
        { "wind km/h", WF_DIM_SPEED, 1 / 3.6, 4 },
        { "u_km_h", WF_DIM_SPEED, 1 / 3.6, 1 },
        { "u (m/s)", WF_DIM_SPEED, 1, 2 },
        { "u [ kn ]", WF_DIM_SPEED, 1852 / 3600.0, 2 },
        { "u_kts", WF_DIM_SPEED, 1852 / 3600.0, 1 },
        { "u_ms", WF_DIM_SPEED, 1, 1 },
        { "t_ms", WF_DIM_TIME, 1e-3, 1 },
        { "u_c", WF_DIM_SPEED, 0, 3 },
        { "u_mean", WF_DIM_SPEED, 0, 6 },
        { "u_kn", WF_DIM_FORCE, 0, 4 },
        { "F_kN", WF_DIM_FORCE, 1000, 1 },
        { "F_kp", WF_DIM_FORCE, 9.80665, 1 },
        { "Force(100)", WF_DIM_FORCE, 0, 10 },
        { "girth_inch", WF_DIM_LENGTH, 0.0254, 5 },
        { "height (ft)", WF_DIM_LENGTH, 0.3048, 7 },
        { "tilt (\xC2\xB0)", WF_DIM_ANGLE, 0.017453292519943295, 5 },
        { "strain [\xC2\xB5m/m]", WF_DIM_NONE, 1e-6, 7 },
    };
    struct wf_units *u;
    assert_int_equal(wf_units_open(&u, NULL), WF_OK);
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        double factor = 0;
        size_t stem = 99;
        bool found = wf_name_unit(u, all[i].name, all[i].dimension, &factor, &stem, NULL);
        if (found != (all[i].factor > 0)) fail_msg("%s", all[i].name);
        if (found) assert_close(factor, all[i].factor, 1e-12);
        assert_int_equal(stem, all[i].stem);
    }
    assert_true(wf_unit_known(u, "kN") && wf_unit_known(u, "km/h"));
    assert_false(wf_unit_known(u, "avg") || wf_unit_known(u, "100"));
    wf_units_close(u);
}

static void marks_by_rule(void **unused)
{
    (void)unused;
    static const struct {
        double value[6];
        bool alone, none;
        size_t missing, doubtful; /* 6: none */
    } all[] = {
        { { 5, 7, 99, 8, 99, 6 }, true, false, 2, 6 },
        { { 5, 7, 99, 8, 9, 6 }, true, false, 0, 2 },
        { { 5, 7, 99, 8, 9, 6 }, true, true, 0, 6 },
        { { 5, 60, 99, 8, 99, 6 }, true, false, 0, 2 }, /* not above twice the next */
        { { 5, 7, 99.9, 999, 99.9, 999 }, true, false, 4, 6 },
        { { 5, -7, 8, 8, 9, 6 }, true, false, 1, 6 },
        { { 5, -7, 8, 8, 9, 6 }, false, false, 0, 6 },
        { { 5, -7, -99.9, 8, -99.9, 6 }, false, false, 2, 6 },
        { { 5, 7, 80, 8, 80, 6 }, true, false, 0, 6 },
        { { 5, 7, 8, 9, 8, 6 }, true, false, 0, 6 },
        { { NAN, 7, 99, 8, 99, 6 }, true, false, 2, 6 },
    };
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        double v[6];
        struct wf_marks m = { .impossible = 90, .unsigned_ = all[i].alone, .none = all[i].none };
        memcpy(v, all[i].value, sizeof v);
        assert_true(wf_marks_find(&m, v, 6));
        if (m.missing != all[i].missing || m.doubtful != all[i].doubtful)
            fail_msg("%zu: %zu missing, doubtful %zu", i, m.missing, m.doubtful);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(times_of_every_kind),
        cmocka_unit_test(units_in_names),
        cmocka_unit_test(other_encodings),
        cmocka_unit_test(marks_by_rule),
        cmocka_unit_test(units_are_those_of_the_names),
        cmocka_unit_test(separators_times_and_heads),
        cmocka_unit_test(marks_are_told_from_peaks),
        cmocka_unit_test(trees_by_hand),
        cmocka_unit_test(pull_tests),
        cmocka_unit_test(free_sway_has_a_rate),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
