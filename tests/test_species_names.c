/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Names of species: which table a name finds, in five languages, and what is said of a name that finds none.
 */
#include "base/text.h"
#include "close.h"
#include "data/species_names.h"
#include "load/drag.h"
#include "load/load.h"
#include "shell.h"

static struct wf_species_library read_all(struct wf_arena *a)
{
    struct wf_species_library l;
    struct wf_diag d = { .arena = a };
    struct wf_err e = { 0 };
    assert_int_equal(wf_species_library_read(".", &wf_laws, a, &l, &d, &e), WF_OK);
    assert_null(d.first);
    assert_true(l.n >= 36);
    return l;
}

static void names_are_folded(void **state)
{
    (void)state;
    static const char *const rows[][2] = {
        { "Quercus robur", "quercus robur" },
        { "chêne PÉDONCULÉ", "chene pedoncule" },
        { "Weißbuche", "weissbuche" },
        { "norway_spruce", "norway spruce" },
        { "See-Kiefer", "see kiefer" },
        { "Platanus × acerifolia", "platanus x acerifolia" },
        { "e\xCC\x81pice\xCC\x81"
          "a",
          "epicea" },
        { "Łódź", "lodz" },
        { "毛竹", "毛竹" },
        { "a  - b", "a b" },
        { "", "" },
    };
    struct wf_arena a = { 0 };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        assert_string_equal(wf_text_folded(rows[i][0], &a), rows[i][1]);
    wf_arena_free(&a);
}

static void distances_count_characters(void **state)
{
    (void)state;
    assert_int_equal(wf_word_distance("毛竹", "毛竺"), 1);
    assert_int_equal(wf_word_distance("欧洲云杉", "云杉"), 2);
    assert_true(wf_word_is_near("毛竹", 1));
    assert_false(wf_word_is_near("毛竹", 2));
}

/* Every table has names in every language, and no name means two tables. */
static void every_name_means_one_table(void **state)
{
    (void)state;
    enum { MOST = 2000 };
    static const char *folded[MOST];
    static size_t owner[MOST];
    struct wf_arena a = { 0 };
    struct wf_species_library l = read_all(&a);
    size_t n = 0;
    for (size_t i = 0; i < l.n; i++) {
        const char *name;
        assert_true(l.species[i].name_zh && l.species[i].latin && l.species[i].aliases >= 2);
        for (size_t k = 0; (name = wf_species_name(&l.species[i], k, &a)); k++, n++) {
            assert_true(n < MOST);
            folded[n] = wf_text_folded(name, &a);
            owner[n] = i;
            assert_ptr_equal(wf_species_name_with(&l.species[i], name, &a) ? name : NULL, name);
            for (size_t j = 0; j < n; j++)
                if (owner[j] != i && !strcmp(folded[j], folded[n]))
                    fail_msg("'%s' is a name of %s and %s", name, l.species[owner[j]].key, l.species[i].key);
        }
    }
    assert_true(n > 250);
    wf_arena_free(&a);
}

static void names_find_tables(void **state)
{
    (void)state;
    static const char *const rows[][2] = {
        { "oak", "oak" },
        { "Quercus robur", "oak" },
        { "quercus petraea", "oak" },
        { "Stieleiche", "oak" },
        { "chene pedoncule", "oak" },
        { "夏栎", "oak" },
        { "tilia cordata", "lime" },
        { "Winterlinde", "lime" },
        { "Rosskastanie", "horse_chestnut" },
        { "Roßkastanie", "horse_chestnut" },
        { "black locust", "robinia" },
        { "épicéa", "norway_spruce" },
        { "EPICEA", "norway_spruce" },
        { "Norway spruce", "norway_spruce" },
        { "欧洲云杉", "norway_spruce" },
        { "毛竹", "moso_bamboo" },
        { "Phyllostachys pubescens", "moso_bamboo" },
        { "悬铃木", "plane" },
        { "Platanus × acerifolia", "plane" },
        { "weißbuche", "hornbeam" },
        { "橡树", "oak" },
        { "Tilia cordata 'Greenspire'", "lime" },
        { "Quercus robur “Fastigiata”", "oak" },
        { "栎树", "oak" },
        { "桦树", "birch" },
        { "法桐", "plane" },
    };
    struct wf_arena a = { 0 };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char want[80];
        const char *path = "nothing";
        struct wf_err e = { 0 };
        snprintf(want, sizeof want, "./species/%s.yaml", rows[i][1]);
        if (wf_species_path(".", rows[i][0], &wf_laws, &a, &path, &e)) fail_msg("%s", e.text);
        assert_string_equal(path, want);
    }
    wf_arena_free(&a);
}

static void near_tables_are_few_and_in_order(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_species_library l = read_all(&a);
    const struct wf_species *near[2];
    assert_int_equal(wf_species_near(&l, "Acer campestre", &a, near, 2), 2);
    assert_string_equal(near[0]->key, "norway_maple");
    assert_string_equal(near[1]->key, "silver_maple");
    assert_int_equal(wf_species_near(&l, "European black poplar of the garden", &a, near, 2), 1);
    assert_string_equal(near[0]->key, "poplar");
    assert_int_equal(wf_species_near(&l, "qqqqq", &a, near, 2), 0);
    assert_int_equal(wf_species_near(&l, "", &a, near, 2), 0);
    wf_arena_free(&a);
}

static void unknown_names_have_near_ones(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W species show 'Quercus robor'", CODE_INPUT, { "did you mean 'oak' (Quercus robur)?" } },
        { "$W analyze 'acer campestre' $RUN",
          CODE_INPUT,
          { "'norway_maple' (Acer platanoides), 'silver_maple' (Acer saccharinum) or 'sycamore' (Acer "
            "pseudoplatanus)?" } },
        { "$W analyze 毛竺 $RUN", CODE_INPUT, { "or 'moso_bamboo' (Phyllostachys edulis)?" } },
        /* trees of several tables, in the words of everyday: all of them, and no others */
        { "for s in pine pin 松树 Pinus; do $W species show $s; done 2>&1 | sort -u | grep -v \"^'\" | sed "
          "'s/[^;]*;//' | uniq -c",
          CODE_OK,
          { "      4  say which: 'loblolly_pine', 'lodgepole_pine', 'maritime_pine', 'masson_pine', "
            "'radiata_pine' or "
            "'scots_pine'\n" } },
        { "for s in maple Ahorn érable 槭树 枫树; do $W species show $s; done 2>&1 | sed 's/[^;]*;//' | uniq "
          "-c",
          CODE_OK,
          { "      5  say which: 'norway_maple' (Acer platanoides), 'silver_maple' (Acer saccharinum) or "
            "'sycamore' "
            "(Acer pseudoplatanus)\n" } },
        { "for s in willow Weide saule 柳树; do $W species show $s; done 2>&1 | sed 's/[^;]*;//' | uniq -c",
          CODE_OK,
          { "      4  say which: 'weeping_willow' (Salix babylonica), 'white_willow' (Salix alba) or "
            "'willow_feng1999' "
            "(Salix sp.)\n" } },
        { "for s in Quercus 'Quercus sp.' 'quercus spp.' 'red oak' Roteiche 红栎; do $W species show \"$s\"; "
          "done 2>&1 | sed "
          "'s/[^;]*;//' | uniq -c",
          CODE_OK,
          { "      6  did you mean 'oak' (Quercus robur)?\n" } },
        { "for s in alder aulne 柏树 榕树 樟树 Erle; do $W species show \"$s\"; done 2>&1 | sed 's/[^;]*;//' "
          "| uniq -c",
          CODE_OK,
          { "      6  'windfirm species list' shows them\n" } },
        { "$W species show fir",
          CODE_INPUT,
          { "'chinese_fir' (Cunninghamia lanceolata) or 'douglas_fir' (Pseudotsuga menziesii)?" } },
        { "$W species show 云杉", CODE_INPUT, { "'norway_spruce'", "'sitka_spruce'" } },
        { "$W species show oka", CODE_INPUT, { "did you mean 'oak' (Quercus robur)?" } },
        { "$W species show larch", CODE_INPUT, { "did you mean 'japanese_larch' (Larix kaempferi)?" } },
        { "$W species show birtch", CODE_INPUT, { "did you mean 'birch'" } },
        { "$W species show qqqqq",
          CODE_INPUT,
          { "qqqqq: there is no such file, and no shipped species table of that name; 'windfirm species "
            "list' shows them" } },
        { "$W shelter --model culm --species 毛竺", CODE_INPUT, { "'moso_bamboo'" } },
    };
    CHECK(rows);
}

static void species_are_searched(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W species list --search linde", CODE_OK, { "lime ", "found by Linde" } },
        { "$W species list --search CHENE", CODE_OK, { "oak ", "found by chêne" } },
        { "$W species list --search 松 | grep -c 'found by'", CODE_OK, { "9\n" } },
        { "$W species list --search ahorn | cut -d' ' -f1",
          CODE_OK,
          { "norway_maple\nplane\nsilver_maple\nsycamore\n" } },
        { "$W species list --search qqq", CODE_INPUT, { "no table has 'qqq' in a name\n" } },
        { "$W species list --search 'Quercus rubra'", CODE_INPUT, { "the nearest: oak\n" } },
        { "$W species show oak --search x", CODE_INPUT, { "--search: has no effect without 'list'" } },
        { "$W species show 'Quercus robur'",
          CODE_OK,
          { "oak, Oak", "names: European oak, English oak", "Stieleiche" } },
        { "$W species list | wc -l", CODE_OK, { "37\n" } },
        { "mkdir -p $T/species; cp species/*.yaml $T/species; sed -i 's/^latin/latn/' $T/species/oak.yaml\n"
          "WINDFIRM_SHARE=$T $W species list",
          CODE_INPUT,
          { "unknown key 'latn'; did you mean 'latin'?", "sycamore" } },
    };
    CHECK(rows);
}

static void names_are_a_list_of_texts(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "for n in elm '[]' '[[elm]]' \"[elm, '']\"; do\n"
          "sed \"s/^names:.*/names: $n/\" species/oak.yaml >$T/x.yaml; $W species show $T/x.yaml; done",
          CODE_INPUT,
          { "6:8: error: names: a list of texts is expected, not",
            "names: the list is empty; texts are expected", "names[0]: a text is expected, not a list",
            "names[1]: a text is expected, not" } },
        { "$W schema species",
          CODE_OK,
          { "\n  names\n", "a list [..] of texts", "if absent: no further names" } },
    };
    CHECK(rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names_are_folded),
        cmocka_unit_test(distances_count_characters),
        cmocka_unit_test(every_name_means_one_table),
        cmocka_unit_test(names_find_tables),
        cmocka_unit_test(near_tables_are_few_and_in_order),
        cmocka_unit_test(unknown_names_have_near_ones),
        cmocka_unit_test(species_are_searched),
        cmocka_unit_test(names_are_a_list_of_texts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
