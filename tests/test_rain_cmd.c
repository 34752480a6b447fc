/* SPDX-License-Identifier: GPL-3.0-or-later */
/* windfirm rain and windfirm papers yang2011: what is printed, written, refused. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "shell.h"

static void runs(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W rain --staged --no-report --duration 1.5 -o $T/r && ls $T/r/tables && head -1 "
          "$T/r/tables/series.csv",
          CODE_OK,
          { "staged drops", "map_1_1.csv", "run,time_s,air", "assumed-values" } },
        { "$W rain --preset yang2011 --drops 20 --grid 64 --leaves 2 --duration 1 --no-report -o $T/r",
          CODE_OK,
          { "impact-energy", "cap-height", "restoring-springs", "explicit-euler" } },
        { "$W rain --intensity 50mm/h --wind 5 --gust kaimal --duration 0.5 --no-report -o $T/r",
          CODE_OK,
          { "rain", "off by" } },
        { "for i in 0 1 2 3 4 5 6 7 8 9; do for j in 0 1 2 3 4 5; do echo 0.0$i 0.00$j 0.0$i; done; done "
          ">$T/p; "
          "$W rain --points $T/p --clusters 5 --duration 0.1 --no-report -o $T/r && cat "
          "$T/r/tables/clusters.csv",
          CODE_OK,
          { "cluster,x_m,y_m,z_m,points" } },
        { "$W rain --model broadleaf --species oak --leaves 2 --duration 0.1 --no-report -o $T/r",
          CODE_OK,
          { "2 leaves" } },
        { "$W rain --model broadleaf --species oak --leaves 1 --duration 0.05 --no-report -q -o $T/r && echo "
          "quiet",
          CODE_OK,
          { "quiet" } },
        /* the stem's 12 segments are the prisms; its wood is that of a stem */
        { "$W rain --tree docs/examples/scan.csv --species oak --leaves 2 --segment 3 --duration 0.05 "
          "--no-report -o $T/r && grep -c ,branch, $T/r/tables/scene.csv; "
          "awk -F, '$11 == 0' docs/examples/scan.csv | wc -l",
          CODE_OK,
          { "2 leaves", "12\n12\n" } },
        /* leaf and petiole of the species, unless they are given; its angle only without the paper's preset
         */
        { "$W rain --species birch --duration 0.05 --no-report -q -o $T/r && grep -E "
          "'\"(leaf_cm2|petiole_mm|petiole_diameter_mm|contact_angle_deg)\"' $T/r/results.json",
          CODE_OK,
          { "\"leaf_cm2\": 12", "\"petiole_mm\": 18", "\"petiole_diameter_mm\": 0.9",
            "\"contact_angle_deg\": 100" } },
        { "$W rain --species birch --petiole 25mm --leaf-length 5cm --preset yang2011 --duration 0.05 "
          "--no-report -q -o $T/r && grep -E '\"(vein_mm|petiole_mm|contact_angle_deg)\"' "
          "$T/r/results.json",
          CODE_OK,
          { "\"vein_mm\": 50", "\"petiole_mm\": 25", "\"contact_angle_deg\": 60" } },
        /* a record of another frequency and speed is another rain; its own mean unless it is rescaled */
        { "$W rain --gust record --file docs/examples/sonic.csv --duration 1 --no-report -q -o $T/r && "
          "$W rain --gust record --file docs/examples/sonic.csv --set rescale=1 --wind 3 --duration 1 "
          "--no-report -q -o $T/s && ! cmp -s $T/r/tables/air.csv $T/s/tables/air.csv && echo differ",
          CODE_OK,
          { "differ" } },
        { "$W papers list", CODE_OK, { "yang2011", "rain on branches and leaves" } },
        { "$W papers yang201", CODE_INPUT, { "did you mean 'yang2011'?" } },
    };
    CHECK(rows);
}

static void refused(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W rain --preset yang2011 --loss 1.2", CODE_INPUT, { "--loss" } },
        { "$W rain --contact-angle 0 --no-report -o $T/r", CODE_INPUT, { "contact angle" } },
        { "$W rain --contact-angle 180 --no-report -o $T/r", CODE_INPUT, { "contact angle" } },
        { "$W rain --grid 0", CODE_INPUT, { "--grid" } },
        { "$W rain --grid 5000", CODE_INPUT, { "--grid" } },
        { "$W rain --intensity=-3mm/h", CODE_INPUT, { "--intensity" } },
        { "$W rain --drop-size 9mm --no-report -o $T/r", CODE_INPUT, { "break up" } },
        { "$W rain --method euler --step 1e-3 --no-report -o $T/r", CODE_INPUT, { "limit" } },
        { "$W rain --method euler --damping-ratio 0 --no-report -o $T/r", CODE_INPUT, { "without damping" } },
        { "$W rain --model culm --segment 99999 --no-report -o $T/r",
          CODE_INPUT,
          { "no segment with the id 99999" } },
        { "$W rain --model culm --branch 1m", CODE_INPUT, { "has no effect", "whose axis has its own" } },
        { "$W rain --preset yang2011 --shaking", CODE_INPUT, { "has no effect", "yang2011" } },
        { "$W rain --segment 3", CODE_INPUT, { "without --model or --tree" } },
        { "$W rain --strict", CODE_INPUT, { "without --tree" } },
        { "$W rain --model culm --tree docs/examples/scan.csv --no-report -o $T/r",
          CODE_INPUT,
          { "one of --model, --tree and --points" } },
        { "$W rain --gust record --duration 1 --no-report -o $T/r",
          CODE_INPUT,
          { "needs the file of an anemometer" } },
        { "$W rain --gust record --file docs/examples/sonic.csv --wind 5",
          CODE_INPUT,
          { "--wind: has no effect", "rescale=1" } },
        { "$W rain --gust kaimal --no-report -o $T/r", CODE_INPUT, { "needs a mean wind above 0" } },
        { "$W rain --gust kaimal --wind 3 --file x", CODE_INPUT, { "without --gust record" } },
        { "$W rain --adhesion 1e-4", CODE_INPUT, { "has no effect", "yang2011" } },
        { "$W rain --staged --drops 200", CODE_INPUT, { "has no effect" } },
        { "$W rain --drops 200 --intensity 10mm/h --no-report -o $T/r",
          CODE_INPUT,
          { "either --drops or --intensity" } },
        { "printf '0 0 0\\n1 1 1\\n' >$T/p; $W rain --points $T/p --no-report -o $T/r",
          CODE_INPUT,
          { "a point for each" } },
        { "printf '0 0 0\\n1 x 1\\n' >$T/p; $W rain --points $T/p --no-report -o $T/r",
          CODE_INPUT,
          { "p:2:1" } },
        { "for i in 1 2 3 4 5 6; do echo 1 0 0; echo 2 0 0; done >$T/p; $W rain --points $T/p --clusters 4 "
          "--no-report -o $T/r",
          CODE_INPUT,
          { "stays empty", "take fewer clusters" } },
        { "sed '/^crown:/,$d' species/birch.yaml >$T/birch.yaml; $W rain --species $T/birch.yaml "
          "--no-report -o $T/r",
          CODE_INPUT,
          { "has no leaves", "leaf_mass_per_area" } },
        { "$W rain --leaf-length 0", CODE_INPUT, { "--leaf-length" } },
        { "$W rain --petiole-diameter 0", CODE_INPUT, { "--petiole-diameter" } },
        { "$W rain --receding 80deg --advancing 70deg --no-report -o $T/r",
          CODE_INPUT,
          { "receding contact angle" } },
        { "$W rain --species willow_feng1999 --form pinnate", CODE_INPUT, { "--form" } },
    };
    CHECK(rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(runs), cmocka_unit_test(refused) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
