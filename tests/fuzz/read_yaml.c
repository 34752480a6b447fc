/* SPDX-License-Identifier: GPL-3.0-or-later */
/* YAML under a schema that has every kind of key: base/yaml.h. */
#include "base/yaml.h"
#include "fuzz.h"
#include <math.h>
#include <string.h>

struct part {
    double length, angle;
    size_t count;
};
struct all {
    const char *text, *name, *choice, *joined;
    int word;
    double plain;
    double *number, *same;
    size_t numbers, sames, parts, pairs, words;
    const char **words_of;
    struct part part, *list;
    struct wf_yaml_pair *pair;
    bool given;
};

static const char *const words[] = { "one", "two", "three", NULL };

#define T struct part
static const struct wf_yaml_row part_rows[] = {
    WF_KEY_LENGTH("length", length, "m", 0, 100, "a length", .required = true),
    WF_KEY_QUANTITY("angle", angle, WF_DIM_ANGLE, "deg", -7, 7, "an angle", .example = "5 deg"),
    WF_KEY_INTEGER("count", count, 1, 9, "a count", .initial = "3"),
    { .key = NULL },
};
#undef T
static const struct wf_yaml_table part_table = {
    .title = "a part", .row = part_rows, .size = sizeof(struct part), .bare = "length"
};

#define T struct all
static const struct wf_yaml_row all_rows[] = {
    WF_KEY_TEXT("text", text, "a text", .example = "a"),
    WF_KEY_NAME("name", name, "a name", .required = true),
    WF_KEY("choice", WF_YAML_CHOICE, choice, "a choice", .choices = words),
    WF_KEY_ENUM("word", word, words, "a word", .example = "one"),
    WF_KEY("joined", WF_YAML_JOINED, joined, "joined", .example = "a"),
    WF_KEY_NUMBER("plain", plain, -1, 1, "a number", .example = "1"),
    WF_KEY_NUMBERS("numbers", number, numbers, 0, 1, "numbers", .example = "[1]"),
    WF_KEY_NUMBERS("sames", same, sames, -10, 10, "as many", .same_length_as = "numbers", .example = "[1]"),
    WF_KEY("pairs", WF_YAML_TEXTS, pair, "pairs", .count = offsetof(T, pairs)),
    WF_KEY("words", WF_YAML_WORDS, words_of, "words", .count = offsetof(T, words), .example = "[a, b]"),
    WF_KEY_LIST("list", list, parts, part_table, "parts", .example = "[]"),
    WF_KEY_PART("part", part_table, "a part", .offset = offsetof(T, part), .given = 1 + offsetof(T, given)),
    { .key = NULL },
};
#undef T

static void finish(struct wf_yaml *y, void *out)
{
    const struct all *a = out;
    (void)wf_yaml_raw(y, "text");
    (void)wf_yaml_has(y, "part.length");
    (void)wf_yaml_where(y, "list[1].length");
    wf_yaml_ascending(y, "numbers", a->numbers, a->number);
}

static const struct wf_yaml_table all_table = {
    .title = "all kinds", .row = all_rows, .size = sizeof(struct all), .finish = finish
};

static void check_part(const struct part *p)
{
    must(p->length >= 0 && p->length <= 100, "a length lies in its range");
    must(isnan(p->angle) || (p->angle >= -7 && p->angle <= 7), "an angle lies in its range");
    must(p->count >= 1 && p->count <= 9, "a count lies in its range");
}

static enum wf_status reading(struct fuzz *f)
{
    struct all a = { 0 };
    enum wf_status s = wf_yaml_read(f->path, &all_table, &a, &f->arena, &f->diag, &f->err);
    if (s) return s;
    must(a.name && a.name[0] &&
             strspn(a.name, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") ==
                 strlen(a.name),
         "a name is a name");
    must(!a.choice || !strcmp(a.choice, "one") || !strcmp(a.choice, "two") || !strcmp(a.choice, "three"),
         "a choice is one of them");
    must(a.word >= 0 && a.word < 3, "a word is one of them");
    must(isnan(a.plain) || fabs(a.plain) <= 1, "a number lies in its range");
    for (size_t i = 0; i < a.numbers; i++) {
        must(a.number[i] >= 0 && a.number[i] <= 1, "each number lies in its range");
        must(!i || a.number[i] > a.number[i - 1], "numbers ascend");
    }
    must(!a.sames || a.sames == a.numbers, "lists are equally long");
    for (size_t i = 0; i < a.pairs; i++) must(a.pair[i].key && a.pair[i].text, "a pair has key and text");
    for (size_t i = 0; i < a.words; i++) must(a.words_of[i] && a.words_of[i][0], "a text is not empty");
    for (size_t i = 0; i < a.parts; i++) check_part(&a.list[i]);
    if (a.given) check_part(&a.part);
    return WF_OK;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) { return fuzz_read(data, size, reading); }
