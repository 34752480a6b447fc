/* SPDX-License-Identifier: GPL-3.0-or-later */
/* MATLAB files: trees in them, damaged ones, and the process of its own in which the program reads them. */
#include "close.h"
#include "data/species.h"
#include "grow/import_mat.h"
#include "grow/import_pack.h"
#include "grow/qsm_write.h"
#include "imported.h"
#include "shell.h"
#include <dirent.h>
#include <fcntl.h>
#include <malloc.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>

#ifdef WF_MATIO
#include "mat_files.h"
#include <zlib.h>

#define BAD "tests/data/mat/"

static void refused(const char *path, const char *words)
{
    struct imported t;
    import_path(&t, path);
    assert_int_equal(t.status, WF_EINPUT);
    if (!strstr(t.err.text, words)) fail_msg("%s\ndoes not say '%s'", t.err.text, words);
    wf_arena_free(&t.arena);
}

/* ---- Files that are sound ---- */

static void assert_mat_tree(const char *path, size_t models)
{
    struct imported t;
    import_path(&t, path);
    if (t.status) fail_msg("%s", t.err.text);
    assert_sound(&t.qsm);
    assert_int_equal(t.qsm.n, 3);
    assert_string_equal(t.qsm.format, "MATLAB file");
    assert_close(t.metrics.volume, M_PI * (0.05 * 0.05 + 0.04 * 0.04 * 0.5 + 0.02 * 0.02 * 0.5), 1e-6);
    assert_int_equal(t.qsm.order[2], 1);
    assert_int_equal(t.qsm.added[2], 1);
    assert_int_equal(t.qsm.repairs.count[WF_NOTE_MODELS], models - 1);
    wf_arena_free(&t.arena);
}

static void structures_plain_and_compressed(void **state)
{
    (void)state;
    struct scratch s;
    scratch_write(&s, "", 0);
    for (size_t models = 1; models <= 3; models += 2) {
        mat_write(s.path, MAT_FT_MAT5, MAT_COMPRESSION_NONE, models);
        assert_mat_tree(s.path, models);
        mat_write(s.path, MAT_FT_MAT5, MAT_COMPRESSION_ZLIB, models);
        assert_mat_tree(s.path, models);
    }
    struct stat size;
    assert_int_equal(stat(s.path, &size), 0);
    assert_int_equal(truncate(s.path, size.st_size / 2), 0);
    refused(s.path, "cut off");
    scratch_remove(&s);
}

static void one_variable(const char *path, matvar_t *v)
{
    mat_t *mat = Mat_CreateVer(path, NULL, MAT_FT_MAT5);
    assert_int_equal(Mat_VarWrite(mat, v, MAT_COMPRESSION_NONE), 0);
    Mat_VarFree(v);
    assert_int_equal(Mat_Close(mat), 0);
}

/* A tree whose part cannot be used is an error, not a tree without that part. */
static void files_without_a_whole_tree(void **state)
{
    (void)state;
    struct scratch s;
    double data[6] = { 0 };
    static const char *few[] = { "radius", "start", "length", "axis" };
    scratch_write(&s, "", 0);
    one_variable(s.path, Mat_VarCreate("x", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, (size_t[]){ 2, 3 }, data, 0));
    refused(s.path, "no tree in 1 variables");
    matvar_t *v = Mat_VarCreateStruct("cylinder", 2, (size_t[]){ 1, 1 }, few, 4);
    Mat_VarSetStructFieldByName(v, "radius", 0, column(MAT_C_SINGLE, MAT_T_SINGLE, 1, radius));
    Mat_VarSetStructFieldByName(v, "start", 0, column(MAT_C_SINGLE, MAT_T_SINGLE, 3, start));
    Mat_VarSetStructFieldByName(v, "length", 0, column(MAT_C_SINGLE, MAT_T_SINGLE, 1, length));
    Mat_VarSetStructFieldByName(v, "axis", 0, column(MAT_C_SINGLE, MAT_T_SINGLE, 1, axis));
    one_variable(s.path, v);
    refused(s.path, "axis of the cylinders has too few columns");
    v = Mat_VarCreateStruct("cylinder", 2, (size_t[]){ 1, 1 }, few, 4); /* no parent */
    Mat_VarSetStructFieldByName(v, "radius", 0, column(MAT_C_SINGLE, MAT_T_SINGLE, 1, radius));
    Mat_VarSetStructFieldByName(v, "start", 0, column(MAT_C_SINGLE, MAT_T_SINGLE, 3, start));
    Mat_VarSetStructFieldByName(v, "length", 0, column(MAT_C_SINGLE, MAT_T_SINGLE, 1, length));
    Mat_VarSetStructFieldByName(v, "axis", 0, column(MAT_C_SINGLE, MAT_T_SINGLE, 3, axis));
    one_variable(s.path, v);
    refused(s.path, "parent of the cylinders is missing");
    v = cylinder("cylinder"); /* a part that is not needed, but is not numbers either */
    static char words[] = "no!";
    Mat_VarFree(Mat_VarSetStructFieldByName(v, "added", 0, column(MAT_C_CHAR, MAT_T_UINT8, 1, words)));
    one_variable(s.path, v);
    refused(s.path, "added of the cylinders is not a table of real numbers");
    scratch_remove(&s);
}

/* ---- Files that are damaged ---- */

static void damaged_files_in_this_process(void **state)
{
    (void)state;
    struct scratch s;
    refused(BAD "field_without_name.mat", "damaged");
    refused(BAD "damaged_zlib.mat", "is compressed, and its data are damaged");
    refused(BAD "crash_v73.mat", "read by the program only");
    scratch_write(&s, "", 0);
    mat_write(s.path, MAT_FT_MAT73, MAT_COMPRESSION_NONE, 1);
    refused(s.path, "read by the program only");
    scratch_remove(&s);
}

/* Compress every variable of a version 5 file, so that damage within passes the check of zlib. */
static void compress_variables(struct file *f)
{
    struct file out = { malloc(4 * f->size + 4096), 128 };
    assert_non_null(out.bytes);
    memcpy(out.bytes, f->bytes, out.size);
    for (size_t at = 128, size; at + 8 <= f->size; at += size) {
        uint32_t n, tag[2] = { MAT_T_COMPRESSED, 0 };
        memcpy(&n, f->bytes + at + 4, sizeof n);
        size = n < f->size - at - 8 ? n + 8 : f->size - at;
        uLongf packed = compressBound(size);
        assert_int_equal(compress(out.bytes + out.size + 8, &packed, f->bytes + at, size), Z_OK);
        tag[1] = (uint32_t)packed;
        memcpy(out.bytes + out.size, tag, sizeof tag);
        out.size += 8 + packed;
    }
    free(f->bytes);
    *f = out;
}

enum end { READ, REFUSED, DIFFERS, STOPPED, ENDS };

/* Read a file as the program's own process does, in a process of its own with a second of time: twice, with
 * different bytes in fresh memory. */
static void read_apart(const char *path, wf_import_reader *reader)
{
    char *text[2] = { NULL };
    size_t size[2] = { 0 };
    int nowhere = open("/dev/null", O_WRONLY);
    struct rlimit second = { 1, 1 };
    static const int deadly[] = { SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT };
    for (size_t k = 0; k < 5; k++) (void)signal(deadly[k], SIG_DFL); /* cmocka catches them */
    if (dup2(nowhere, STDERR_FILENO) < 0 || setrlimit(RLIMIT_CPU, &second)) _exit(ENDS);
    struct wf_err e = { 0 };
    for (int k = 0; k < 2; k++) {
        struct wf_arena a = { 0 };
        struct wf_diag d = { .arena = &a };
        struct wf_qsm q = { .file = path };
        struct wf_import_head h = { .path = path };
        struct wf_import_options o = wf_import_default();
        o.strict = true;
        e = (struct wf_err){ 0 };
        mallopt(M_PERTURB, k ? 0xAA : 0x55);
        (void)reader(&h, &o, &a, &q, &d, &e);
        FILE *to = open_memstream(&text[k], &size[k]);
        if (!to || wf_import_pack(&q, &d, &e, to) || fclose(to)) _exit(ENDS);
        wf_arena_free(&a);
    }
    if (size[0] != size[1] || memcmp(text[0], text[1], size[0]) != 0) _exit(DIFFERS);
    _exit(e.code ? REFUSED : READ);
}

enum { VARIANTS = 500 };

/* Read so many damaged variants of a file. Returned: how each ended. */
static void read_variants(enum mat_ft version, enum matio_compression packed, bool repack,
                          wf_import_reader *reader, size_t ended[ENDS])
{
    struct scratch s;
    uint32_t seed = 20261128;
    memset(ended, 0, ENDS * sizeof *ended);
    scratch_write(&s, "", 0);
    mat_write(s.path, version, packed, 1);
    struct file whole = file_load(s.path);
    for (size_t k = 0; k < VARIANTS; k++) {
        struct file f = { malloc(whole.size), whole.size };
        assert_non_null(f.bytes);
        memcpy(f.bytes, whole.bytes, whole.size);
        file_damage(&f, version == MAT_FT_MAT73 ? 512 : 128, &seed);
        if (repack) compress_variables(&f);
        file_save(s.path, &f);
        fflush(NULL);
        pid_t child = fork();
        if (!child) read_apart(s.path, reader);
        int status = 0;
        assert_int_equal(waitpid(child, &status, 0), child);
        ended[WIFEXITED(status) && WEXITSTATUS(status) < ENDS ? WEXITSTATUS(status) : STOPPED]++;
        free(f.bytes);
    }
    free(whole.bytes);
    scratch_remove(&s);
    print_message("%zu read, %zu refused, %zu with uninitialised memory, %zu stopped\n", ended[READ],
                  ended[REFUSED], ended[DIFFERS], ended[STOPPED]);
    assert_int_equal(ended[READ] + ended[REFUSED] + ended[DIFFERS] + ended[STOPPED], VARIANTS);
}

static void damaged_variants_of_version_5(void **state)
{
    (void)state;
    size_t ended[ENDS];
    static const struct {
        enum matio_compression packed;
        bool repack;
    } kinds[] = { { MAT_COMPRESSION_NONE, false },
                  { MAT_COMPRESSION_ZLIB, false },
                  { MAT_COMPRESSION_NONE, true } };
    for (size_t k = 0; k < 3; k++) {
        read_variants(MAT_FT_MAT5, kinds[k].packed, kinds[k].repack, wf_import_mat, ended);
        assert_int_equal(ended[DIFFERS], 0);
        assert_int_equal(ended[STOPPED], 0);
        assert_true(ended[REFUSED] > VARIANTS / 10);
    }
}

/* libhdf5 may crash and hang; that is why it has a process of its own. */
static void damaged_variants_of_version_73(void **state)
{
    (void)state;
    size_t ended[ENDS];
    read_variants(MAT_FT_MAT73, MAT_COMPRESSION_NONE, false, wf_import_mat_apart, ended);
    assert_true(ended[READ] > VARIANTS / 10);
}

/* ---- The program ---- */

/* The shipped pull test with the scan in place of its tree. */
#define STUDY                                                                                                \
    "cp -r models/field/data $T/; sed \"s|model: sample_pine.yaml|qsm: $MATS/v73.mat|; "                     \
    "s|height: [0-9.]* m|height: 1 m|\" $S > $T/s.yaml\n"

static void the_program_reads_in_a_process_of_its_own(void **state)
{
    (void)state;
    static const char *const versions[] = { "v5.mat", "packed.mat", "v73.mat" };
    char folder[] = "/tmp/windfirm-test-XXXXXX", path[128], command[512];
    assert_non_null(mkdtemp(folder));
    for (size_t k = 0; k < 3; k++) {
        snprintf(path, sizeof path, "%s/%s", folder, versions[k]);
        mat_write(path, k == 2 ? MAT_FT_MAT73 : MAT_FT_MAT5,
                  k == 1 ? MAT_COMPRESSION_ZLIB : MAT_COMPRESSION_NONE, 2);
    }
    setenv("MATS", folder, 1);
    static const struct row rows[] = {
        { "for f in v5 packed v73; do $W import $MATS/$f.mat -o $T/$f.csv || exit; done\n"
          "cmp $T/v5.csv $T/packed.csv && cmp $T/v5.csv $T/v73.csv",
          0,
          { "v5.mat: MATLAB file, 3 cylinders", "packed.mat: MATLAB file, 3 cylinders",
            "v73.mat: MATLAB file, 3 cylinders", "[further-models]: v73.mat: 1 further" } },
        { "$W tree info $MATS/v73.mat", 0, { "3 cylinders" } },
        { "$W tree draw $MATS/v73.mat -o $T/t.svg", 0, { NULL } },
        { "$W analyze scots_pine --tree $MATS/v73.mat --wind 10 --no-report -o $T/out", 0, { NULL } },
        { "$W compare scots_pine beech --tree $MATS/v73.mat --wind 10 --no-report -o $T/out", 0, { NULL } },
        { "$W shelter --species scots_pine --tree $MATS/v73.mat -o $T/out", 0, { NULL } },
        { STUDY "$W simulate-test $T/s.yaml -o $T/plan", 0, { "[further-models]", "Simulated readings" } },
        { STUDY "$W fit $T/s.yaml -o $T/out --no-report", 0, { "[further-models]", "Results, tables" } },
        { STUDY "sed \"s|^fit .*|fit $T/s.yaml|; /^case hundred/,\\$d\" validation/recovery/pull_test.case "
                ">$T/a.case; $W validate $T/a.case | grep -c 'only, in a process'",
          1,
          { "0" } },
    };
    CHECK(rows);
    snprintf(command, sizeof command, "rm -r %s", folder);
    assert_int_equal(shell(command), 0);
}

/* Models of the tree whose radii grow by a tenth from one to the next, as a structure array or as cells. */
static void models_write(const char *path, size_t models, bool cells)
{
    float as_is[3];
    memcpy(as_is, radius, sizeof as_is);
    mat_t *mat = Mat_CreateVer(path, NULL, MAT_FT_MAT5);
    assert_non_null(mat);
    matvar_t *all =
        cells ? Mat_VarCreate("QSMs", MAT_C_CELL, MAT_T_CELL, 2, (size_t[]){ 1, models }, NULL, 0)
              : Mat_VarCreateStruct("QSM", 2, (size_t[]){ 1, models }, (const char *[]){ "cylinder" }, 1);
    for (size_t k = 0; k < models; k++) {
        for (int i = 0; i < 3; i++) radius[i] = as_is[i] * (float)(1 + 0.1 * (double)k);
        matvar_t *one =
            cells ? Mat_VarCreateStruct(NULL, 2, (size_t[]){ 1, 1 }, (const char *[]){ "cylinder" }, 1) : all;
        Mat_VarSetStructFieldByName(one, "cylinder", cells ? 0 : k, cylinder(NULL));
        if (cells) Mat_VarSetCell(all, (int)k, one);
    }
    assert_int_equal(Mat_VarWrite(mat, all, MAT_COMPRESSION_NONE), 0);
    Mat_VarFree(all);
    assert_int_equal(Mat_Close(mat), 0);
    memcpy(radius, as_is, sizeof as_is);
}

static void one_model_of_several_is_chosen(void **state)
{
    (void)state;
    static const char *const number[] = { NULL, "1", "2", "3" };
    char path[] = "/tmp/windfirm-test-XXXXXX";
    close(mkstemp(path));
    for (int cells = 0; cells < 2; cells++) {
        models_write(path, 3, cells);
        for (size_t k = 0; k < 4; k++) {
            struct imported t;
            struct wf_import_options o = wf_import_default();
            o.scan_model = number[k];
            import_with(&t, path, o);
            if (t.status) fail_msg("%s", t.err.text);
            assert_int_equal(t.qsm.models, 3);
            assert_int_equal(t.qsm.repairs.count[WF_NOTE_MODELS], k ? 0 : 2);
            assert_close(t.qsm.r0[0], 0.05 * (1 + 0.1 * (double)(k > 1 ? k - 1 : 0)), 1e-7);
            wf_arena_free(&t.arena);
        }
        struct imported t;
        struct wf_import_options o = wf_import_default();
        o.scan_model = "4";
        import_with(&t, path, o);
        assert_int_equal(t.status, WF_EINPUT);
        assert_non_null(strstr(t.err.text, "--scan-model 4: the file has 3 models"));
        wf_arena_free(&t.arena);
    }
    setenv("MODELS", path, 1);
    static const struct row rows[] = {
        { "$W tree info $MODELS", 0, { "2 further tree models" } },
        { "$W tree info $MODELS --scan-model 3", 0, { "base diameter       0.1200 m", "repairs " } },
        { "$W tree info $MODELS --scan-model all",
          0,
          { "3 models of one tree", "range over 3 models: height 1.500 to 1.500 m, dbh 0.0800 to 0.0960 m",
            "wood 0.0109956 to 0.0158336 m3" } },
        { "$W tree info $MODELS --csv --scan-model all | cut -d, -f1", 0, { "#1\"", "#2\"", "#3\"" } },
        { "$W tree info $MODELS --scan-model 0", 2, { "'0': not the number of a model" } },
        { "$W import $MODELS --scan-model all", 2, { "by its number" } },
        { "$W import $D/plain.csv --scan-model 1", 2, { "only a MATLAB file" } },
        { "$W analyze oak --tree $MODELS --scan-model all --wind 10 --leaf-area 200 --no-report -o $T/o; "
          "grep "
          "-c scan-models "
          "$T/o/results.json",
          0,
          { "scan-models", "over 3 of 3 models of the scan: critical wind speed ",
            "lowest of model 1 (--scan-model 1)", "height 1.50 to 1.50 m" } },
        { "$W analyze oak --model models/culm.yaml --scan-model all --wind 10", 2, { "--tree" } },
    };
    CHECK(rows);
    unlink(path);
}

static void the_program_survives_damaged_files(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W import tests/data/mat/field_without_name.mat", 2, { "is damaged" } },
        { "$W import tests/data/mat/damaged_zlib.mat", 2, { "is compressed, and its data are damaged" } },
        { "$W import tests/data/mat/crash_v73.mat $D/plain.csv",
          2,
          { "crash_v73.mat", "plain.csv: plain CSV" } },
        { "ulimit -t 1; $W import tests/data/mat/hang_v73.mat $D/plain.csv; c=$?; [ $c -le 2 ]; exit",
          0,
          { "hang_v73.mat", "plain.csv: plain CSV" } },
        { "$W --read-mat; $W --read-mat 1 tests/data/mat/crash_v73.mat ''", 2, { NULL } },
    };
    CHECK(rows);
    assert_int_equal(shell("$W import tests/data/mat/crash_v73.mat 2>&1 | grep -c 'HDF5-DIAG'; true"), 0);
    assert_string_equal(output, "0\n");
}

/* Variants of each kind through the whole program, with two fillings of fresh memory: the same words, never a
 * signal. Few, because each starts two processes. */
static void the_program_says_the_same_twice(void **state)
{
    (void)state;
    enum { FEW = 15 };
    char folder[] = "/tmp/windfirm-test-XXXXXX", path[128];
    uint32_t seed = 7;
    assert_non_null(mkdtemp(folder));
    for (size_t kind = 0; kind < 3; kind++) {
        snprintf(path, sizeof path, "%s/whole", folder);
        mat_write(path, kind == 2 ? MAT_FT_MAT73 : MAT_FT_MAT5,
                  kind == 1 ? MAT_COMPRESSION_ZLIB : MAT_COMPRESSION_NONE, 1);
        struct file whole = file_load(path);
        for (int k = 0; k < FEW; k++) {
            struct file f = { malloc(whole.size), whole.size };
            assert_non_null(f.bytes);
            memcpy(f.bytes, whole.bytes, whole.size);
            file_damage(&f, kind == 2 ? 512 : 128, &seed);
            snprintf(path, sizeof path, "%s/%zu_%02d.mat", folder, kind, k);
            file_save(path, &f);
            free(f.bytes);
        }
        free(whole.bytes);
    }
    setenv("MATS", folder, 1);
    int code =
        shell("ulimit -t 2; for p in 1 200; do MALLOC_PERTURB_=$p $W import $MATS/*.mat >$T/$p 2>&1; c=$?\n"
              "[ $c -le 2 ] || exit 9; done; cmp $T/1 $T/200; c=$?; rm -r $MATS; exit $c");
    if (code) fail_msg("exit code %d: %s", code, output);
}

/* Scans of other people, when they are there: both ways give the same rows. */
static void real_files_both_ways(void **state)
{
    (void)state;
    const char *reference = getenv("WINDFIRM_REFERENCE");
    char name[2048], command[4096], private[] = "/tmp/windfirm-test-XXXXXX", rows[64];
    assert_non_null(mkdtemp(private));
    snprintf(rows, sizeof rows, "%s/rows.csv", private);
    snprintf(name, sizeof name, "%s/trees/qsm", reference ? reference : "");
    DIR *folder = reference ? opendir(name) : NULL;
    size_t n = 0;
    for (struct dirent *f; folder && (f = readdir(folder));) {
        size_t size = strlen(f->d_name);
        if (size < 4 || strcmp(f->d_name + size - 4, ".mat") != 0) continue;
        struct imported t;
        snprintf(name, sizeof name, "%s/trees/qsm/%s", reference, f->d_name);
        import_path(&t, name);
        if (t.status) fail_msg("%s", t.err.text);
        assert_int_equal(wf_qsm_write(&t.qsm, rows, NULL, &t.err), WF_OK);
        wf_arena_free(&t.arena);
        snprintf(command, sizeof command, "$W import -q %s -o $T/t.csv && cmp $T/t.csv %s", name, rows);
        int code = shell(command);
        if (code) fail_msg("%s: %s", name, output);
        n++;
    }
    if (folder) closedir(folder);
    (void)unlink(rows);
    (void)rmdir(private);
    if (!n) {
        print_message("skipped: no .mat files; WINDFIRM_REFERENCE may name a folder with trees/qsm\n");
        skip();
    }
    print_message("%zu real files\n", n);
}

#else
static void without_libmatio(void **state)
{
    (void)state;
    struct imported t;
    static const char text[] = "MATLAB 5.0 MAT-file, Platform: GLNXA64";
    import_text(&t, text, sizeof text);
    assert_int_equal(t.status, WF_EMISSING);
    assert_non_null(strstr(t.err.text, "libmatio-dev"));
    wf_arena_free(&t.arena);
}
#endif

/* ---- The answer of the process that reads ---- */

struct bytes {
    char *text;
    size_t size;
};

/* A table of three cylinders, two of its rows unreadable, as an answer. */
static struct bytes some_answer(enum wf_status code, const char *message)
{
    struct wf_arena a = { 0 };
    struct wf_diag d = { .arena = &a };
    struct wf_err e = { 0 };
    struct wf_qsm q = { .file = "t.mat", .format = "MATLAB file", .models = 2 };
    struct bytes b = { NULL, 0 };
    assert_int_equal(wf_qsm_alloc(&q, 3, &a, &e), WF_OK);
    for (size_t i = 0; i < 3; i++) {
        q.id[i] = (int64_t)i + 1, q.parent_id[i] = (int64_t)i;
        q.z0[i] = (double)i, q.z1[i] = (double)i + 1;
        q.r0[i] = 0.1;
    }
    wf_import_bad_row(&q, true, 4, 0, "no start point", &d);
    wf_import_bad_row(&q, true, 5, 0, "no start \033[31m point", &d);
    if (code) (void)wf_fail(&e, code, "%s", message);
    FILE *to = open_memstream(&b.text, &b.size);
    assert_int_equal(wf_import_pack(&q, &d, &e, to), WF_OK);
    assert_int_equal(fclose(to), 0);
    wf_arena_free(&a);
    return b;
}

static void unpack(struct imported *t, const void *bytes, size_t size, bool strict)
{
    struct wf_import_options o = wf_import_default();
    o.strict = strict;
    memset(t, 0, sizeof *t);
    t->diag.arena = &t->arena;
    t->qsm.file = "t.mat", t->qsm.name = "t.mat";
    t->status = wf_import_unpack(bytes, size, "t.mat", &o, &t->arena, &t->qsm, &t->diag, &t->err);
}

static void an_answer_comes_back(void **state)
{
    (void)state;
    struct imported t;
    struct bytes b = some_answer(WF_OK, NULL);
    unpack(&t, b.text, b.size, false);
    assert_int_equal(t.status, WF_OK);
    assert_int_equal(t.qsm.n, 3);
    assert_int_equal(t.qsm.models, 2);
    assert_int_equal(t.qsm.id[2], 3);
    assert_int_equal(t.qsm.parent_id[2], 2);
    assert_close(t.qsm.z1[2], 3, 1e-15);
    assert_true(t.qsm.r0[0] == 0.1 && isnan(t.qsm.r1[0]) && isnan(t.qsm.length[0]));
    assert_string_equal(t.qsm.format, "MATLAB file");
    assert_int_equal(t.qsm.repairs.count[WF_REPAIR_BAD_ROW], 2);
    assert_int_equal(t.qsm.repairs.first[WF_REPAIR_BAD_ROW], 4);
    assert_int_equal(t.diag.warnings, 2);
    assert_string_equal(t.diag.first->text, "t.mat:4: no start point");
    assert_string_equal(t.diag.last->text, "t.mat:5: no start ?[31m point");
    wf_arena_free(&t.arena);
    unpack(&t, b.text, b.size, true);
    assert_int_equal(t.diag.errors, 2);
    wf_arena_free(&t.arena);
    free(b.text);
    b = some_answer(WF_EINPUT, "t.mat: no \001 tree");
    unpack(&t, b.text, b.size, false);
    assert_int_equal(t.status, WF_EINPUT);
    assert_string_equal(t.err.text, "t.mat: no ? tree");
    wf_arena_free(&t.arena);
    free(b.text);
}

static void a_damaged_answer_is_refused(void **state)
{
    (void)state;
    struct imported t;
    struct bytes b = some_answer(WF_OK, NULL);
    for (size_t size = 0; size < b.size; size++) { /* cut off anywhere */
        unpack(&t, b.text, size, false);
        assert_int_equal(t.status, WF_EINPUT);
        assert_non_null(strstr(t.err.text, "answer is damaged"));
        wf_arena_free(&t.arena);
    }
    char *more = malloc(b.size + 1); /* too long */
    assert_non_null(more);
    memcpy(more, b.text, b.size);
    more[b.size] = 0;
    unpack(&t, more, b.size + 1, false);
    assert_int_equal(t.status, WF_EINPUT);
    wf_arena_free(&t.arena);
    /* words of all ones and of large numbers at every place: counts, sizes and values that no reader writes
     */
    static const int64_t wild[] = { -1, INT64_MAX, INT64_MIN, (int64_t)1 << 40, 0x7FF0000000000000 };
    size_t refusals = 0;
    for (size_t at = 0; at + 8 <= b.size; at++)
        for (size_t k = 0; k < 5; k++) {
            memcpy(more, b.text, b.size);
            memcpy(more + at, &wild[k], 8);
            unpack(&t, more, b.size, false);
            assert_true(t.status == WF_OK || t.status == WF_EINPUT || t.status == WF_ENOMEM);
            if (!t.status)
                for (size_t i = 0; i < t.qsm.n; i++)
                    assert_true(isfinite(t.qsm.z0[i]) && isfinite(t.qsm.z1[i]));
            refusals += t.status != WF_OK;
            wf_arena_free(&t.arena);
        }
    assert_true(refusals > b.size);
    free(more);
    free(b.text);
}

static void random_bytes_are_refused(void **state)
{
    (void)state;
    struct imported t;
    struct bytes b = some_answer(WF_OK, NULL);
    srand(5);
    for (int k = 0; k < 20000; k++) {
        size_t from = (size_t)(rand() % (int)b.size);
        char *x = malloc(b.size);
        assert_non_null(x);
        memcpy(x, b.text, b.size);
        for (size_t i = k % 2 ? from : 0; i < b.size && (k % 2 == 0 || i < from + 8); i++)
            x[i] = (char)rand();
        unpack(&t, x, b.size, false);
        if (k % 2 == 0) assert_int_equal(t.status, WF_EINPUT);
        wf_arena_free(&t.arena);
        free(x);
    }
    free(b.text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
#ifdef WF_MATIO
        cmocka_unit_test(structures_plain_and_compressed),
        cmocka_unit_test(files_without_a_whole_tree),
        cmocka_unit_test(damaged_files_in_this_process),
        cmocka_unit_test(damaged_variants_of_version_5),
        cmocka_unit_test(damaged_variants_of_version_73),
        cmocka_unit_test(the_program_reads_in_a_process_of_its_own),
        cmocka_unit_test(one_model_of_several_is_chosen),
        cmocka_unit_test(the_program_survives_damaged_files),
        cmocka_unit_test(the_program_says_the_same_twice),
        cmocka_unit_test(real_files_both_ways),
#else
        cmocka_unit_test(without_libmatio),
#endif
        cmocka_unit_test(an_answer_comes_back),
        cmocka_unit_test(a_damaged_answer_is_refused),
        cmocka_unit_test(random_bytes_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
