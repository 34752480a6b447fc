/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Options that have no effect beside the others, lists, names of shipped files, pipes. */
#include "close.h"
#include "fit/lsq.h"
#include "shell.h"
#include "wind/gust.h"

#define NOT "has no effect "
#define A "$W analyze moso_bamboo $RUN "

static void test_profiles(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { A "--canopy-height 5 --attenuation 2",
          CODE_INPUT,
          { "--canopy-height: " NOT, "--attenuation: " NOT } },
        { A "--exponent 0.2 --profile log", CODE_INPUT, { "--exponent: " NOT "with the profile 'log'" } },
        { A "--roughness 0.1", CODE_INPUT, { "--roughness: " NOT "with the profile 'power'" } },
        { A "--displacement 1 --profile uniform", CODE_INPUT, { "--displacement: " NOT } },
        { A "--roughness 0.1 --displacement 1 --profile log", CODE_OK, { "critical" } },
        { A "--roughness 0.1 --dem docs/examples/heights.asc --at 1700,1450", CODE_OK, { "critical" } },
        { "$W explain oak $M --wind 5 --no-report -o $T/o --exponent 0.2 --profile log",
          CODE_INPUT,
          { "--exponent: " NOT } },
        { "$W shelter --model culm --species oak --exponent 0.2 --profile log",
          CODE_INPUT,
          { "--exponent: " NOT } },
        { "$W series oak $M --exponent 0.2 --profile log", CODE_INPUT, { "--exponent: " NOT } },
        { "printf 'study: a\\nspecies: oak\\nmodel: culm\\nwind: 10\\nprofile: log\\nexponent: 0.2\\nnorth: "
          "5\\n' "
          ">$T/s.yaml; $W analyze $T/s.yaml",
          CODE_INPUT,
          { "s.yaml:6:11: error: exponent: " NOT, "s.yaml:7:8: error: north: " NOT } },
        { "sed 's/wind: 10 m.s/&, exponent: 0.2, profile: log/' models/papers/tang2012.yaml >$T/p.yaml; $W "
          "papers "
          "$T/p.yaml --no-report --no-vtk -o $T/o",
          CODE_INPUT,
          { "exponent: " NOT "with the profile 'log'" } },
        { "cat tests/data/fit/moso_wind.yaml >$T/f.yaml; sed -i 's/wind: *{/wind: {attenuation: 1, /' "
          "$T/f.yaml; "
          "$W fit $T/f.yaml",
          CODE_INPUT,
          { "attenuation: " NOT "with the profile" } },
    };
    CHECK(rows);
}

static void test_variants(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { A "--solver chain --preset tang2012",
          CODE_INPUT,
          { "--solver: " NOT "with the preset 'tang2012'" } },
        { A "--solver chain --preset corrected", CODE_OK, { "solver chain" } },
        { A "--joint bridge", CODE_INPUT, { "--joint: " NOT "with --model" } },
        { A "--north 10 --at 1,2", CODE_INPUT, { "--north: " NOT, "--at: " NOT } },
        { A "--altitude 100 --air-density 1.2", CODE_INPUT, { "--altitude: " NOT "beside --air-density" } },
        { A "--preset zhao2013 --air-density 1.2", CODE_INPUT, { "--air-density: " NOT } },
        { A "--solver deflect --root-stiffness 1e5",
          CODE_INPUT,
          { "--root-stiffness: " NOT "with the solver" } },
        { A "--solver chain --root-stiffness 1e5", CODE_OK, { "critical" } },
        /* softer than its weight: it would hang below its root, hardly stressed */
        { A "--root-stiffness 50", CODE_INPUT, { "roots of 0.05 kN m/rad do not hold the tree upright" } },
        { A "--root-stiffness 1e5", CODE_OK, { "critical" } },
        { A "--solver chain --mesh-tolerance 1e-3", CODE_INPUT, { "--mesh-tolerance: " NOT } },
        { A "--averaging in-land", CODE_INPUT, { "--averaging: " NOT } },
        { "$W analyze oak $M --wind beaufort:8 --averaging-time 3",
          CODE_INPUT,
          { "--averaging-time: " NOT } },
        { A "--leaf-area 5 --season leaf_off", CODE_INPUT, { "--leaf-area: " NOT } },
        { "$W analyze oak --tree docs/examples/scan.csv --wind 10 --season leaf_on",
          CODE_INPUT,
          { "--season: " NOT } },
        { "$W series oak $M --intensity 0.1 --seed 3 --components 3 --set period=3",
          CODE_INPUT,
          { "--intensity: " NOT "with the gust model 'steady'", "--seed: " NOT, "--components: " NOT,
            "--set: " NOT } },
        { "$W series oak $M --gust kaimal --period 3 --file a.csv --columns t,u",
          CODE_INPUT,
          { "--period: " NOT "with the gust model 'kaimal'", "--file: " NOT, "--columns: " NOT } },
        { "$W series oak $M --restoring 0.1 --damping 1 --leaf-period 2",
          CODE_INPUT,
          { "--restoring: " NOT "with the solver 'beam'", "--damping: " NOT, "--leaf-period: " NOT } },
        { "$W wind record --file docs/examples/sonic.csv --wind 20 --seed 2 --intensity 0.1",
          CODE_INPUT,
          { "--wind: " NOT, "--seed: " NOT, "--intensity: " NOT } },
        { "$W wind record --file docs/examples/sonic.csv --wind 20 --set rescale=1 --no-plots -o $T/o",
          CODE_OK,
          { "mean wind               20.0" } },
        { "$W wind kaimal --file a.csv --spacing 3", CODE_INPUT, { "--file: " NOT, "--spacing: " NOT } },
        { "$W wind kaimal --stream $T/a.csv -o $T/o", CODE_INPUT, { "--output: " NOT "with --stream" } },
        { "$W wind list --wind 5", CODE_INPUT, { "--wind: " NOT "with 'list'" } },
        { "$W wind rose --file docs/examples/rose.csv --seed 5",
          CODE_INPUT,
          { "--seed: " NOT "with 'rose'" } },
        { "$W terrain --dem docs/examples/heights.asc --size 3 --seed 4",
          CODE_INPUT,
          { "--size: " NOT, "--seed: " NOT } },
        { "$W shelter --model culm --species oak --strict --leaf-area 3 --law feng1999 --wake-growth 0.1",
          CODE_INPUT,
          { "--strict: " NOT "without a measured tree", "--leaf-area: " NOT, "--wake-growth: " NOT } },
        { "$W fit $S --loss-scale 2 --seed 3", CODE_INPUT, { "--loss-scale: " NOT, "--seed: " NOT } },
        { "sed 's/solver          linear chain/solver deflect\\nsupport spring 100 N m\\/rad/' "
          "docs/examples/mast.case "
          ">$T/m.case; $W validate $T/m.case",
          CODE_INPUT,
          { NOT "with the solver 'deflect'" } },
    };
    CHECK(rows);
}

/* What is said of soil and root: one source, that can be used. */
static void test_anchorage(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W analyze oak $M --wind 10 --soil clay",
          CODE_INPUT,
          { "--soil: 'clay' is none of mineral, gleyed" } },
        { "$W analyze oak $M --wind 10 --pull-moment 0", CODE_INPUT, { "--pull-moment: 0 is outside" } },
        { "$W analyze oak $M --wind 10 --pull-moment 12kg", CODE_INPUT, { "--pull-moment", "N m" } },
        { "$W analyze oak $M --wind 10 --pull-moment 12 --root-secant 1e6",
          CODE_INPUT,
          { "give one of --pull-moment and --root-secant" } },
        { "$W analyze oak $M --wind 10 --pull-moment 12 --anchorage size",
          CODE_INPUT,
          { "give one of --pull-moment and --anchorage" } },
        { "$W analyze oak $M --wind 10 --anchorage root-stiffness",
          CODE_INPUT,
          { "needs --root-stiffness" } },
        { "$W analyze oak $M --wind 10 --rooting deep",
          CODE_INPUT,
          { "--rooting: " NOT "without --anchorage-table" } },
        { "printf 'phi_deg,moment_kNm\\n0,9\\n0.2,8\\n' >$T/c.csv; $W analyze oak $M --wind 10 "
          "--tipping-curve $T/c.csv",
          CODE_INPUT,
          { "c.csv:3:5: error: moment_kNm: the curve falls before it rises" } },
        { "printf 'study: a\\nspecies: oak\\nmodel: culm\\nwind: 10\\npull_moment: 12 kN m\\n' "
          ">$T/s.yaml; "
          "$W analyze $T/s.yaml -o $T/o --no-report",
          CODE_OK,
          { "anchorage 30 kN m: 2.5 x 12 kN m at 0.25 deg", "in saturated soil it overturns" } },
        { "$W analyze oak $M --wind 10 -o $T/o --no-report",
          CODE_OK,
          { "overturning not assessed: soil and anchorage unknown" } },
        { "$W analyze oak $M --wind 10 --soil peat -o $T/o --no-report",
          CODE_OK,
          { "32.9 kN m/m3 x d^2 h", "none of Quercus robur" } },
        { "$W analyze moso_bamboo $M --wind 10 --soil peat -o $T/o --no-report",
          CODE_OK,
          { "overturning not assessed: no anchorage test of hollow culms" } },
    };
    CHECK(rows);
}

static void test_lists(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W analyze oak $M --wind 10,5",
          CODE_INPUT,
          { "did you mean the one speed '10.5' or the two speeds '5,10'?" } },
        { "$W analyze oak $M --wind 25,10,15", CODE_INPUT, { "rising order" } },
        { "$W analyze oak $M --wind 10,,20", CODE_INPUT, { "'10,,20': an item of the list is empty" } },
        { "$W analyze oak $M --wind 10,", CODE_INPUT, { "an item of the list is empty" } },
        { "$W analyze oak $M --no-report -o $T/o --wind beaufort:8,9",
          CODE_OK,
          { "beaufort:8: gale", "beaufort:9: strong gale", "        19 ", "     22.65 " } },
        { "$W analyze oak $M --no-report -o $T/o --wind cma:typhoon,severe-typhoon",
          CODE_OK,
          { "cma:severe-typhoon: " } },
        { "$W analyze oak $M --no-report -o $T/o --wind 'beaufort:8,9 m/s'", CODE_OK, { "         9 " } },
        { "$W fit $S --free level0.youngs_modulus,,root.stiffness",
          CODE_INPUT,
          { "an item of the list is empty" } },
        { "$W wind kaimal --set displacement=1,,decay-up=2", CODE_INPUT, { "expected name=number" } },
        { "$W wind kaimal --set decay-up=1,decay-up=2", CODE_INPUT, { "decay-up is given twice" } },
        { "$W wind record --file docs/examples/sonic.csv --columns t_s,,u_ms",
          CODE_INPUT,
          { "columns 't_s,,u_ms'" } },
        { "printf 'study: a\\nspecies: [oak, \"\", ash]\\nmodel: culm\\nwind: 5\\n' >$T/s.yaml; $W compare "
          "$T/s.yaml",
          CODE_INPUT,
          { "species: an item of the list is empty" } },
    };
    CHECK(rows);
}

static void test_names(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "export WINDFIRM_SHARE=$PWD; W=$PWD/$W; cd $T && mkdir oak culm && $W analyze oak --model culm "
          "--wind 10 "
          "--no-report",
          CODE_OK,
          { "oak is a folder here", "culm is a folder here", "critical wind speed" } },
        { "$W analyze aok $M --wind 10", CODE_INPUT, { "did you mean 'oak' (Quercus robur)?" } },
        { "$W analyze oak --model clum --wind 10", CODE_INPUT, { "did you mean 'culm'?" } },
        { "$W explain poplr $M", CODE_INPUT, { "did you mean 'poplar' (Populus spp.)?" } },
        { "$W series poplr $M", CODE_INPUT, { "did you mean 'poplar' (Populus spp.)?" } },
        { "$W shelter --model culm --species poplr", CODE_INPUT, { "did you mean 'poplar' (Populus spp.)?" } },
        { "$W species show moso_bambo", CODE_INPUT, { "did you mean 'moso_bamboo'" } },
        { "$W tree draw --model clum", CODE_INPUT, { "did you mean 'culm'?" } },
        { "$W tree info -s poplr $D/plain.csv", CODE_INPUT, { "did you mean 'poplar' (Populus spp.)?" } },
        { "sed 's/species: scots_pine/species: scots_pin/' $S >$T/f.yaml; $W fit $T/f.yaml",
          CODE_INPUT,
          { "did you mean 'scots_pine'" } },
        { "$W papers tang201", CODE_INPUT, { "did you mean 'tang2012'?" } },
        { "$W papers lst", CODE_INPUT, { "did you mean 'list'?" } },
        { "$W papers list", CODE_OK, { "tang2012", "feng1999", "zhao2013", "source: " } },
        { "$W wind rse", CODE_INPUT, { "did you mean 'rose'?" } },
        { "sed 's/gust: cosine/gust: cosin/' models/papers/tang2012.yaml >$T/p.yaml; $W papers $T/p.yaml",
          CODE_INPUT,
          { "gust: 'cosin' is not known; did you mean 'cosine'?" } },
    };
    CHECK(rows);
}

static void test_pipes(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "cat species/oak.yaml | $W analyze /dev/stdin $M --wind 10 -q --no-report -o $T/o && grep -c "
          "$(sha256sum "
          "species/oak.yaml | cut -d' ' -f1) $T/o/results.json",
          CODE_OK,
          { "1" } },
        { "cat models/studies/bamboo_and_willow.yaml | $W compare /dev/stdin --no-report -o $T/o",
          CODE_OK,
          { "Moso bamboo", "Weeping willow" } },
        { "for f in $D/*; do $W tree info --csv -q $f | tail -n 1 | sed 's/^[^,]*,//' >$T/a; cat $f | $W "
          "tree info "
          "--csv -q /dev/stdin | tail -n 1 | sed 's/^[^,]*,//' >$T/b; cmp $T/a $T/b || exit 1; done; echo "
          "same",
          CODE_OK,
          { "same" } },
        { "cat docs/examples/rose.csv | $W wind rose --file /dev/stdin --no-plots -o $T/o",
          CODE_OK,
          { "12 directions" } },
        { "cat docs/examples/pull.csv | $W fit docs/examples/pull.yaml --data /dev/stdin --no-report -o $T/o "
          "&& grep -c "
          "$(sha256sum docs/examples/pull.csv | cut -d' ' -f1) $T/o/results.json",
          CODE_OK,
          { "\n1" } },
        { "cat docs/examples/mast.case | $W validate /dev/stdin", CODE_OK, { "2 passed" } },
    };
    CHECK(rows);
}

static void test_no_nan(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "printf 'fit: z\\nname: z\\ntrees:\\n  - {name: t, species: scots_pine, model: culm}\\ntests:\\n  "
          "- name: s\\n"
          "    sensors: [{name: f, kind: frequency, value: 0.3 Hz, sigma: 0.01 Hz}]\\nfree:\\n  - "
          "{parameter: "
          "level0.youngs_modulus}\\n' >$T/z.yaml; $W fit $T/z.yaml --no-report -o $T/o >$T/log; cat $T/log; "
          "grep -c "
          "'determine every' $T/log; ! grep -i nan $T/log",
          CODE_OK,
          { "reduced chi-square - with 0 degrees of freedom", "\n0\n" } },
        { "$W wind cosine --intensity 0 --duration 60 -o $T/o >$T/log 2>&1 || exit 9; ! grep -i nan $T/log",
          CODE_OK,
          { "" } },
        { "sed 's/^height/shape: under_weight\\n&/;s/^stem:/shape: under_weight\\n&/' models/culm.yaml "
          ">$T/c.yaml; sed "
          "\"s#model: .*#model: $PWD/$T/c.yaml#\" $S >$T/f.yaml; sed -i 's#data/#'$PWD'/models/field/data/#' "
          "$T/f.yaml; "
          "case $T in /*) sed -i \"s#$PWD/$T#$T#\" $T/f.yaml;; esac; $W fit $T/f.yaml",
          CODE_OK,
          { "pull clino_root" } },
    };
    CHECK(rows);
}

/* The slopes of a loss are those of half its rho, by differences. */
static void test_loss_slopes(void **state)
{
    (void)state;
    for (const struct wf_loss_row *l = wf_losses; l->name; l++)
        for (double r = -7.03; r < 7.1; r += 0.37) {
            double a = l->usual_scale, h = 1e-5, psi, slope, low, high, unused;
            l->slopes(a, r, &psi, &slope);
            assert_close(psi, (l->rho(a, r + h) - l->rho(a, r - h)) / (4 * h), 1e-8);
            l->slopes(a, r - h, &low, &unused);
            l->slopes(a, r + h, &high, &unused);
            assert_close(slope, (high - low) / (2 * h), 1e-6);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_profiles), cmocka_unit_test(test_variants),    cmocka_unit_test(test_anchorage),
        cmocka_unit_test(test_lists),    cmocka_unit_test(test_names),       cmocka_unit_test(test_pipes),
        cmocka_unit_test(test_no_nan),   cmocka_unit_test(test_loss_slopes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
