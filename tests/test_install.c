/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The installed library: the example compiles as C and as C++ with the flags pkg-config gives and nothing
 * else, and says what the command says. And the build with flags of one's own. */
#include "close.h"
#include "shell.h"

/* Installed below $T; $P asks pkg-config about it there. A build with sanitizers would need their flags. */
#define INSTALL                                                                                              \
    "case $W in */san/*) echo sanitizers; exit 77;; esac\n"                                                  \
    "command -v pkg-config >/dev/null || { echo no pkg-config; exit 77; }\n"                                 \
    "env -u MAKEFLAGS -u MAKELEVEL make -s install BUILD=$(dirname $W) SAN= DESTDIR=$(realpath $T) "         \
    "PREFIX=/opt >$T/log || { cat $T/log; exit 1; }\n"                                                       \
    "export PKG_CONFIG_PATH=$T/opt/lib/pkgconfig\n"                                                          \
    "P='pkg-config --define-prefix windfirm'\n"                                                              \
    "S=species/moso_bamboo.yaml M=models/culm.yaml\n"

static void needs(int code)
{
    if (code == 77) skip();
    if (code) fail_msg("exit code %d; it printed:\n%s", code, output);
}

static void example_says_what_the_command_says(void **state)
{
    (void)state;
    needs(shell(INSTALL "WARN='-Wall -Wextra -Wpedantic -Werror'\n"
                        "${CC:-cc} -std=c17 $WARN docs/examples/critical.c $($P --cflags --libs) -o $T/c &&\n"
                        "${CXX:-c++} -std=c++17 $WARN -x c++ docs/examples/critical.c -x none $($P --cflags "
                        "--libs) -o $T/cxx &&\n"
                        "$T/c $S $M 20 >$T/c.txt && $T/cxx $S $M 20 | cmp - $T/c.txt || exit 1\n"
                        "cat $T/c.txt\n"
                        "$W analyze $S --model $M --wind 20 --no-report -o $T/out |\n"
                        "    awk '$1 == 20 { tip = $3 } / critical wind speed / { speed = $4 }\n"
                        "         END { printf \"tip %s m, critical wind %s m/s\\n\", tip, speed }' |\n"
                        "    cmp - $T/c.txt"));
    assert_non_null(strstr(output, "critical wind "));
}

static void says_its_version(void **state)
{
    (void)state;
    needs(shell(INSTALL "test \"windfirm $($P --modversion)\" = \"$($T/opt/bin/windfirm --version)\""));
}

static void finds_what_is_shipped(void **state)
{
    (void)state;
    /* also after another installation from the same build */
    needs(shell("mkdir -p $(dirname $W)/install && echo /another >$(dirname $W)/install/prefix\n" INSTALL
                "strings -a $T/opt/bin/windfirm | grep -qx /opt/share/windfirm &&\n"
                "test -e $T/opt/share/windfirm/$S && grep -qx /opt $(dirname $W)/install/prefix"));
}

/* Flags of whoever builds stand beside those without which a file is another one. */
static void builds_with_own_flags(void **state)
{
    (void)state;
    needs(shell("n=$(env -u MAKEFLAGS -u MAKELEVEL make -n BUILD=$T/own SAN= FUZZ= CFLAGS='-O0 -g' "
                "$T/own/windfirm |\n"
                "    grep -c -e '-O0 -g .*-DWF_WIDTH=[48] .*beam_[a-z]*_[48].o$')\n"
                "test \"$n\" = 6 || { echo \"$n of 6 kernels have their width\"; exit 1; }"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(example_says_what_the_command_says),
        cmocka_unit_test(says_its_version),
        cmocka_unit_test(finds_what_is_shipped),
        cmocka_unit_test(builds_with_own_flags),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
