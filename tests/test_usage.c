/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the program says of itself: help, manual pages, completion, JSON Schema, starters. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "shell.h"

#define COMMANDS "$($W --help=words | awk -F'\\t' '$2 == \"command\" { print $1 }')"

/* Every option of the help stands on the manual page and among the words, for every command. */
static void every_option_is_everywhere(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "n=0; for c in " COMMANDS "; do $W $c --help=man >$T/man; $W $c --help=words >$T/words;"
          " for o in $($W $c --help | sed -nE 's/^  (-[a-z], )?(--[a-z0-9-]+).*/\\2/p'); do n=$((n+1));"
          " grep -qF \"fB$(echo $o | sed 's/-/\\\\-/g')\" $T/man || echo \"$c $o: not in the manual\";"
          " cut -f1 $T/words | grep -qxe \"$o\" || echo \"$c $o: not among the words\"; done; done;"
          " [ $n -gt 250 ] && echo enough",
          CODE_OK,
          { "enough" } },
    };
    CHECK(rows);
    assert_null(strstr(output, ": not "));
}

static void manual_pages_are_clean(void **state)
{
    (void)state;
    if (shell("command -v groff >/dev/null")) skip();
    static const struct row rows[] = {
        { "$W --help=man | groff -man -Tutf8 -ww 2>&1 >/dev/null; for c in " COMMANDS
          "; do $W $c --help=man | groff -man -Tutf8 -ww 2>&1 >$T/page; [ -s $T/page ] || echo empty: $c; "
          "done",
          CODE_OK,
          { "" } },
        { "$W analyze --help=man | groff -man -Tascii -P-c -P-b -P-u | grep -nE '^NAME|^EXIT STATUS|--model'",
          CODE_OK,
          { "NAME", "--model", "EXIT STATUS" } },
    };
    check(rows, 1);
    assert_string_equal(output, "");
    check(rows + 1, 1);
}

/* The completion script in a shell: words typed, the last one being completed, and what is offered. */
static void lines_are_completed(void **state)
{
    (void)state;
    if (shell("command -v bash >/dev/null")) skip();
#define TRY(words)                                                                                           \
    "bash -c '. src/windfirm.bash; try() { COMP_WORDS=(\"$0\" \"$@\"); COMP_CWORD=$#; _windfirm "            \
    "2>/dev/null;"                                                                                           \
    " printf \"[%s]\" \"${COMPREPLY[@]}\"; }; try " words "' $W"
    static const struct row rows[] = {
        { TRY("analy"), CODE_OK, { "[analyze]" } },
        { TRY("analyze --mod"), CODE_OK, { "[--model]" } },
        { TRY("analyze --model moso_c"), CODE_OK, { "[moso_culm]" } },
        { TRY("analyze --joint \"\""), CODE_OK, { "[axis][bridge]" } },
        { TRY("analyze moso_b"), CODE_OK, { "[moso_bamboo]" } },
        { TRY("analyze --study READ"), CODE_OK, { "[README.md]" } },
        { TRY("nothing --x"), CODE_OK, { "[]" } },
    };
    CHECK(rows);
}

/* Shipped files are allowed by the schema, mistakes are not. */
static void the_json_schema_holds(void **state)
{
    (void)state;
    static const char files[] = "for f in species/*.yaml; do set -- \"$@\" species=$f; done; for f in "
                                "models/*.yaml; do set -- \"$@\" model=$f; done;"
                                "for f in models/studies/*.yaml; do set -- \"$@\" study=$f; done;"
                                "for f in $(grep -l ^fit: models/field/*.yaml); do set -- \"$@\" fit=$f; "
                                "done; python3 tests/schema.py $W \"$@\"";
    static const struct row wrong[] = {
        { "sed 's/density:/densty:/' species/oak.yaml >$T/a.yaml; python3 tests/schema.py $W "
          "species=$T/a.yaml",
          3 * 2,
          { "densty", "'density' is a required property" } },
        { "sed 's/height: 20 m/height: 20/' models/oak_20m.yaml >$T/a.yaml; python3 tests/schema.py $W "
          "model=$T/a.yaml",
          1,
          { "stem.height" } },
        { "sed 's/power: 0.6/power: 60/; s/ellipse$/elipse/' models/oak_20m.yaml >$T/a.yaml;"
          "python3 tests/schema.py $W model=$T/a.yaml",
          2,
          { "stem.taper.power: 60", "'elipse' is not one of" } },
    };
    int code = shell(files);
    if (code == 77) skip();
    if (code) fail_msg("%s", output);
    CHECK(wrong);
}

static void starters_run(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "W=$(realpath $W); cd $T; for k in species model study fit; do $W init $k my_$k || exit; done;"
          "$W analyze my_species.yaml --model my_model.yaml --wind 20 --no-report -o a --samples 0 && "
          "$W analyze my_study.yaml --no-report -o b --samples 0 && $W simulate-test my_fit.yaml -o c && $W "
          "init tree gate && $W assess gate.yaml --samples 0",
          CODE_OK,
          { "my_species.yaml written", "My species" } },
        { "W=$(realpath $W); cd $T; $W init model x && $W init model x",
          CODE_INPUT,
          { "x.yaml is there already" } },
        { "$W init modle x", CODE_INPUT, { "did you mean 'model'?" } },
        { "$W init model a/b", CODE_INPUT, { "letters, digits" } },
        { "$W init model x -o $T/none/x.yaml", CODE_RUN, { "none" } },
        { "$W init model x -o - | head -n 3", CODE_OK, { "model: x" } },
    };
    CHECK(rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_option_is_everywhere),
        cmocka_unit_test(manual_pages_are_clean),
        cmocka_unit_test(lines_are_completed),
        cmocka_unit_test(the_json_schema_holds),
        cmocka_unit_test(starters_run),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
