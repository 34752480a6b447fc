/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The head of a client's report: what is given stands on the page, escaped; pictures keep nothing of the
 * camera. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "shell.h"

#define CARD "$W assess models/cards/oak.yaml --samples 0 --no-pdf -q -o $T/out "
#define JOB "J=$PWD/tests/data/job; "

static void skip_without_libraries(void)
{
    shell(JOB "$W assess models/cards/oak.yaml --samples 0 -q --photo $J/photo.jpg");
    if (!strstr(output, "built without libjpeg")) return;
    print_message("without libjpeg and libpng: left out\n");
    skip();
}

static void texts(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { CARD
          "--title '</title><script>1</script>' --client 'A & \"B\"' --site-name '<i>Gate' --tree-number "
          "17 --assessor 'C. D' --organisation 'E' --disclaimer ']]>{1}'; tr -d '\\n' <$T/out/report.html | "
          "sed "
          "'s/.*<body[^>]*>//; s/<h2.*//; s/<[^>]*>/ /g' | tr -s ' '; echo; grep -c '<script>1' "
          "$T/out/report.html",
          CODE_RUN,
          { "&lt;/title&gt;&lt;script&gt;1&lt;/script&gt; Oak at the gate",
            "Client A &amp; \"B\" Site &lt;i&gt;Gate", "]]&gt;{1} C. D Name", "\n0\n" } },
        { "printf 'card: K\\nspecies: oak\\nheight: 20 m\\ngirth: 250 cm\\ncrown_width: 14 m\\ncrown_base: 4 "
          "m\\nwind: "
          "25\\nsoil: unknown\\ntitle: T1\\nsite_name: S1\\ntree_number: N1\\n' >$T/c.yaml; $W assess "
          "$T/c.yaml "
          "--samples 0 --no-report -q -o $T/out; grep -oE '\"(title|site|tree_number)\": \"..\"' "
          "$T/out/results.json",
          CODE_OK,
          { "\"title\": \"T1\"", "\"site\": \"S1\"", "\"tree_number\": \"N1\"" } },
        { "$W compare oak beech --model culm --wind 10 --client C1 --no-report -q -o $T/out; grep -c "
          "'\"client\": \"C1\"' "
          "$T/out/results.json",
          CODE_OK,
          { "1" } },
    };
    CHECK(rows);
}

/* Neither folders nor the command line stand on a page; both stand in results.json. */
static void private_things(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "mkdir -p $T/secretfolder; cp models/cards/oak.yaml $T/secretfolder/k.yaml; $W assess "
          "$T/secretfolder/k.yaml --samples 0 --no-pdf -q -o $T/out; grep -c secretfolder "
          "$T/out/results.json; grep -c "
          "-e secretfolder -e samples.0 $T/out/report.html; grep -o '>k.yaml<' $T/out/report.html",
          CODE_OK,
          { "\n0\n>k.yaml<" } },
    };
    CHECK(rows);
}

static void pictures(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { JOB "grep -c CAMERAMAKER $J/photo.jpg; grep -c OWNERNAME $J/logo.png; " CARD
              "--photo $J/photo.jpg --logo $J/logo.png && cat $T/out/plots/*.jpg | grep -c -e CAMERAMAKER -e "
              "GPSSECRET -e "
              "OWNERNAME -e Exif; grep -o '<img class=\"[a-z]*\" src=\"data:image/jpeg;base64,' "
              "$T/out/report.html",
          CODE_OK,
          { "1\n1\n0\n", "<img class=\"logo\" src=\"data:", "<img class=\"photo\" src=\"data:" } },
        /* held upright: 60 by 40 becomes 40 by 60 */
        { JOB CARD "--photo $J/photo.jpg; od -An -v -tx1 $T/out/plots/photo.jpg | tr -d ' \\n' | grep -o "
                   "'ffc0001108........'",
          CODE_OK,
          { "ffc0001108003c0028" } },
        /* a picture that went is said, and the rest is drawn */
        { JOB CARD "--photo $J/photo.jpg && rm $T/out/plots/photo.jpg && $W report $T/out --no-pdf",
          CODE_INPUT,
          { "plots/photo.jpg is missing" } },
    };
    skip_without_libraries();
    CHECK(rows);
}

/* One line, exit code 2, and the report of before stays. */
static void refused(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { JOB CARD "--photo $J/photo.jpg; cksum <$T/out/report.html >$T/a; " CARD
                   "--photo $T/nowhere.jpg; cksum <$T/out/report.html | cmp - $T/a && echo same",
          CODE_OK,
          { "nowhere.jpg: cannot be read", "same" } },
        { JOB CARD "--photo README.md --logo $T", CODE_INPUT, { "README.md: is neither a PNG nor a JPEG" } },
        { JOB "head -c 600 $J/photo.jpg >$T/cut.jpg; " CARD "--photo $T/cut.jpg",
          CODE_INPUT,
          { "it is damaged" } },
        { JOB "head -c 100 $J/logo.png >$T/cut.png; " CARD "--logo $T/cut.png",
          CODE_INPUT,
          { "it is damaged" } },
        { JOB "{ cat $J/photo.jpg; head -c 20000001 /dev/zero; } >$T/big.jpg; " CARD "--photo $T/big.jpg",
          CODE_INPUT,
          { "more than 20 MB" } },
        /* a header that promises 60000 by 60000 pixels */
        { JOB
          "sed "
          "'s/\\xff\\xc0\\x00\\x11\\x08\\x00\\x28\\x00\\x3c/\\xff\\xc0\\x00\\x11\\x08\\xea\\x60\\xea\\x60/' "
          "$J/photo.jpg >$T/huge.jpg; cmp -s $J/photo.jpg $T/huge.jpg && echo unchanged; " CARD
          "--photo $T/huge.jpg",
          CODE_INPUT,
          { "huge.jpg: cannot be read as a picture: it is damaged, or of more than 40 megapixels" } },
    };
    skip_without_libraries();
    CHECK(rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(texts),
        cmocka_unit_test(private_things),
        cmocka_unit_test(pictures),
        cmocka_unit_test(refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
