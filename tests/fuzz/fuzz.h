/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_TESTS_FUZZ_H
#define WF_TESTS_FUZZ_H
/* What the harnesses of tests/fuzz share. A harness is one file read_NAME.c: it gives bytes to one reader of
 * untrusted text. What the reader accepts must be safe to use, so the harness then checks what the reader's
 * header promises, and aborts where a promise is broken. The same object file is linked with libFuzzer (make
 * fuzz, make fuzz-smoke) and with replay.c (make test). They run in the checkout, where species/ is. */
#include "base/arena.h"
#include "base/err.h"
#include "data/tree.h"
#include "grow/qsm.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct wf_species;
struct wf_model;

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* One reading of one input. */
struct fuzz {
    const char *path; /* a file with the input's bytes */
    const uint8_t *data;
    size_t size;
    struct wf_arena arena; /* of FUZZ_ARENA bytes at most; freed after the reading */
    struct wf_diag diag;
    struct wf_err err;
};
enum { FUZZ_ARENA = 1 << 26 };

/* Call `read` on the bytes, then check what holds for every reader: no errors are left with WF_OK, a failure
 * has words and is not an internal fault, and every finding can be printed. Returned: 0, for libFuzzer. */
int fuzz_read(const uint8_t *data, size_t size, enum wf_status (*read)(struct fuzz *f));

/* Abort, naming the broken promise, unless ok. */
void must(bool ok, const char *promise);
/* A step after the reading may refuse, with words. Returned: whether it was done. */
bool fuzz_done(enum wf_status s, const struct wf_err *e);
/* Abort unless the n numbers are finite; NULL is no numbers. */
void must_be_finite(const double *v, size_t n, const char *what);
/* A tree that was grown: wf_tree_check, and apart from it that parents come first and all is finite. */
void must_be_tree(const struct wf_tree *t);

/* A shipped species (name of a file of species/ without its ending), read once and kept. */
const struct wf_species *fuzz_species(const char *name);
/* The shipped model models/culm.yaml, read once and kept. */
const struct wf_model *fuzz_culm(void);

/* Read a tree file of this format (NULL: by content), and check the table, the trees made of it by each way
 * of joining, and that a strict import accepts nothing else. */
int fuzz_import(const uint8_t *data, size_t size, const char *format);
#endif
