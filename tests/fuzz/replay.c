/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs files through one harness without libFuzzer: replay NAME FILE... A child process runs them one after
 * the other under a time limit for each. If it dies, the file is named and another child goes on behind it,
 * so that every file is run. The last line is "[  PASSED  ] 1 test" or "[  FAILED  ] 1 test" with the number
 * of files; exit code 1 if one failed. */
#include "fuzz.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

enum { SECONDS = 10, LARGEST = 1 << 20 };

static void run_file(const char *path)
{
    FILE *f = fopen(path, "rb");
    uint8_t *data = malloc(LARGEST), *exact = NULL;
    size_t size = f && data ? fread(data, 1, LARGEST, f) : 0;
    must(f && data && !ferror(f) && feof(f), "the file can be read and is at most 1 MB");
    fclose(f);
    must((exact = malloc(size + 1)) != NULL, "memory");
    memcpy(exact, data, size); /* no room behind it, so that a sanitizer sees reading past the end */
    free(data);
    LLVMFuzzerTestOneInput(exact, size);
    free(exact);
}

/* From file *at on, in a child. Returned: its exit status as of waitpid. */
static int run_from(int n, char **path, volatile int *at)
{
    int status = -1;
    fflush(NULL);
    pid_t child = fork();
    if (child == 0) {
        for (; *at < n; (*at)++) {
            alarm(SECONDS);
            run_file(path[*at]);
        }
        exit(0);
    }
    return child > 0 && waitpid(child, &status, 0) == child ? status : -1;
}

int main(int argc, char **argv)
{
    int n = argc - 2, failed = 0;
    char **path = argv + 2;
    volatile int *at = mmap(NULL, sizeof *at, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (argc < 3 || at == MAP_FAILED) return fprintf(stderr, "usage: replay NAME FILE...\n"), 2;
    for (*at = 0; *at < n; (*at)++) {
        int status = run_from(n, path, at);
        if (status == 0) break;
        failed++;
        if (*at >= n) break; /* at exit: leaks are found then */
        if (WIFSIGNALED(status))
            printf("%s: %s: %s\n", argv[1], path[*at], strsignal(WTERMSIG(status)));
        else
            printf("%s: %s: stopped\n", argv[1], path[*at]);
    }
    printf("%s: %d files, %d failed\n[  %s  ] 1 test\n", argv[1], n, failed, failed ? "FAILED" : "PASSED");
    return failed != 0;
}
