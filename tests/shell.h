/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_TESTS_SHELL_H
#define WF_TESTS_SHELL_H
/* Commands of the program as rows: what is typed, the exit code, what it prints. */
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { CODE_OK = 0, CODE_RUN = 1, CODE_INPUT = 2 };

static char output[1 << 16];
static const char *program;
static char scratch[200]; /* $T: a folder of this process, so that test programs can run at the same time */

static inline void remove_scratch(void)
{
    char command[300];
    snprintf(command, sizeof command, "rm -rf '%s'", scratch);
    if (system(command)) fprintf(stderr, "%s: stays\n", scratch);
}

static inline void begin_shell(void)
{
    program = getenv("WINDFIRM");
    if (!program) program = "build/windfirm";
    snprintf(scratch, sizeof scratch, "%.150s.%ld.scratch", program, (long)getpid());
    atexit(remove_scratch);
}

/* Run a shell command with $W the program (of the environment's WINDFIRM), $T a scratch folder, $D the
 * measured trees of the tests, $S the shipped sample of a fit, $RUN the rest of a quick analysis; stdout and
 * stderr go to `output`. Returned: exit code, 128 + signal when it was killed. */
static inline int shell(const char *command)
{
    char all[8192];
    if (!program) begin_shell();
    snprintf(all, sizeof all,
             "{ T=%s; W=%s; D=tests/data/qsm; S=models/field/sample_pull.yaml; M='--model "
             "models/culm.yaml'; RUN=\"$M --wind 10 "
             "--no-report -o $T/out\"\n"
             "rm -rf $T; mkdir -p $T\n%s\n} 2>&1 </dev/null",
             scratch, program, command);
    FILE *pipe = popen(all, "r");
    assert_non_null(pipe);
    size_t got = fread(output, 1, sizeof output - 1, pipe);
    output[got] = '\0';
    int status = pclose(pipe);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

struct row {
    const char *command;
    int code;
    const char *expect[5]; /* pieces of the output */
};

static inline void check(const struct row *rows, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        int code = shell(rows[i].command);
        if (code != rows[i].code)
            fail_msg("%s\nexit code %d, want %d; it printed:\n%s", rows[i].command, code, rows[i].code,
                     output);
        for (size_t k = 0; k < sizeof rows[i].expect / sizeof *rows[i].expect && rows[i].expect[k]; k++)
            if (!strstr(output, rows[i].expect[k]))
                fail_msg("%s\ndoes not print '%s' but:\n%s", rows[i].command, rows[i].expect[k], output);
    }
}
#define CHECK(rows) check(rows, sizeof rows / sizeof *rows)
#endif
