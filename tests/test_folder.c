/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A results folder is of one run or says that it is not; and it is data, also a stranger's. */
#include "close.h"
#include "data/out/folder.h"
#include "out/folder.h"
#include "out/run_folder.h"
#include "shell.h"
#include <fcntl.h>
#include <signal.h>

/* ---- What is in a folder ---- */

static void names(void **unused)
{
    (void)unused;
    static const char *const good[] = { "tables/a.csv", "plots/tip.svg", "vtk/run1_00000.vtp", "report.pdf" },
                             *const bad[] = { "",           "/etc/x.html",  "tables/../x.csv", "../x.html",
                                              "tables//a",  "tables/",      "tables/.a",       ".x.html",
                                              "notes.txt",  "results.json", "tables/a\nb",     "plots",
                                              "tables/./a", "a/b/c.html" };
    for (size_t i = 0; i < sizeof good / sizeof *good; i++)
        if (!wf_folder_names(good[i])) fail_msg("'%s' is refused", good[i]);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        if (wf_folder_names(bad[i])) fail_msg("'%s' is taken", bad[i]);
}

static void put(struct folder *f, const char *name, const char *text)
{
    FILE *to = fopen(folder_file(f, name), "wb");
    assert_non_null(to);
    fputs(text, to);
    fclose(to);
}

/* Links are not followed, neither at the end of a name nor in it; other things are no files. */
static void plain_files(void **unused)
{
    (void)unused;
    struct folder f;
    size_t size = 0;
    const char *last;
    assert_true(folder_make(&f));
    mkdir(folder_file(&f, "tables"), 0700);
    mkdir(folder_file(&f, "else"), 0700);
    put(&f, "tables/a.csv", "abc");
    put(&f, "else/b.csv", "b");
    assert_int_equal(symlink("a.csv", folder_file(&f, "tables/link.csv")), 0);
    assert_int_equal(symlink("else", folder_file(&f, "plots")), 0);
    assert_int_equal(mkfifo(folder_file(&f, "tables/pipe.csv"), 0600), 0);
    int dir = open(f.path, O_RDONLY | O_DIRECTORY), fd = wf_folder_open(dir, "tables/a.csv", &size);
    assert_true(fd >= 0);
    assert_int_equal(size, 3);
    close(fd);
    static const char *const bad[] = { "tables/link.csv", "plots/b.csv", "tables/pipe.csv", "tables",
                                       "none" };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        fd = wf_folder_open(dir, bad[i], &size);
        if (fd >= 0) fail_msg("%s is opened", bad[i]);
    }
    assert_int_equal(wf_folder_room(dir, "plots/new.csv", true, &last), -1);
    assert_int_equal(wf_folder_kind(dir, "tables/a.csv"), S_IFREG);
    assert_int_equal(wf_folder_kind(dir, "tables/link.csv"), S_IFLNK);
    assert_int_equal(wf_folder_kind(dir, "tables/none.csv"), 0);
    wf_folder_unlink(dir, "plots/b.csv");
    assert_true(folder_has(&f, "else/b.csv"));
    wf_folder_remove(dir, "plots", 0); /* a link to a folder is not entered */
    assert_true(folder_has(&f, "else/b.csv"));
    close(dir);
    folder_remove(&f);
}

static void lists(void **unused)
{
    (void)unused;
    struct folder f;
    json_t *root = NULL;
    assert_true(folder_make(&f));
    mkdir(folder_file(&f, "tables"), 0700);
    put(&f, "tables/a.csv", "abc");
    put(&f, "results.json",
        "{\"run_files\": [{\"name\": \"tables/a.csv\", \"size\": 3, \"sha256\": "
        "\"ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad\"}]}");
    int dir = open(f.path, O_RDONLY | O_DIRECTORY);
    char *text = wf_folder_document(dir, &root);
    assert_non_null(text);
    const json_t *list = wf_folder_list(root), *x = wf_folder_listed(list, "tables/a.csv");
    assert_non_null(x);
    assert_string_equal(wf_folder_entry(x), "tables/a.csv");
    assert_null(wf_folder_listed(list, "tables/b.csv"));
    assert_null(wf_folder_mismatch(dir, x, -1));
    put(&f, "tables/a.csv", "abd");
    assert_string_equal(wf_folder_mismatch(dir, x, -1), "is not of this run");
    remove(folder_file(&f, "tables/a.csv"));
    assert_string_equal(wf_folder_mismatch(dir, x, -1), "is missing");
    json_decref(root), free(text);
    root = json_pack("{s:[{s:s}]}", "run_files", "name", "tables/../../x");
    assert_null(wf_folder_list(root));
    json_decref(root);
    close(dir);
    folder_remove(&f);
}

/* ---- Commands ---- */

/* `run N FOLDER...`: an analysis at N m/s of one tree without pages. */
#define RUN                                                                                                  \
    "W=$(cd $(dirname $W) && pwd)/$(basename $W); cd $T; run() { v=$1; shift; $W analyze oak --model culm "  \
    "--wind $v -q --no-report -o \"$@\"; }\n"

static void belongs(void **unused)
{
    (void)unused;
    static const struct row rows[] = {
        { RUN "mkdir d; cd d; echo mine >notes.txt; run 10 . && run 12 . && cat notes.txt && ls -A",
          0,
          { "mine\nnotes.txt\nresults.json\ntables\n" } },
        { RUN "mkdir d; ln -s d l; run 10 l && ls -A d && test -h l", 0, { "results.json" } },
        { RUN "run 10 d; echo mine >d/tables/mine.csv; run 12 d --directions 8 && run 10 d && ls d/tables",
          0,
          { "mine.csv\nsegments.csv\nshape.csv\nsummary.csv\nsweep.csv\n" } },
        /* files that no run made are not replaced */
        { RUN "mkdir d; echo mine >d/results.json; run 10 d", 1, { "results.json: is not of windfirm" } },
        { RUN
          "mkdir -p d/tables; echo mine >d/tables/summary.csv; run 10 d; cat d/tables/summary.csv; ls -A d",
          0,
          { "d/tables: no run of windfirm made it", "mine\ntables\n" } },
        { RUN
          "mkdir d; echo mine >d/report.pdf; $W analyze oak --model culm --wind 10 -q -o d; cat d/report.pdf",
          0,
          { "d/report.pdf: no run of windfirm made it", "mine" } },
        { RUN "run 10 d; echo mine >d/tables/directions.csv; run 10 d --directions 8; cat "
              "d/tables/directions.csv",
          0,
          { "directions.csv: no run of windfirm made it", "mine" } },
        /* nothing is left where nothing was made */
        { RUN "run 10 a/b/c --solver linear --preset none; run 10 a/b/c --study none; ls -A", 0, { "" } },
        { RUN "mkdir -p p; test $(id -u) = 0 || { chmod a-w p; run 10 p/d; chmod u+w p; }; run 10 /proc/d; "
              "ls -A p",
          0,
          { "/proc" } },
    };
    CHECK(rows);
}

/* Links in the place of each thing that a run writes or reads. */
static void links(void **unused)
{
    (void)unused;
    static const struct row rows[] = {
        { RUN "mkdir x d; for s in tables plots vtk; do ln -s ../x d/$s; run 10 d; rm d/$s; done; ls -A x d",
          0,
          { "d/tables: is not a folder", "d/plots: is not a folder", "d/vtk: is not a folder",
            "d:\n\nx:\n" } },
        { RUN "echo mine >x; mkdir d; ln -s ../x d/results.json; run 10 d; cat x; readlink d/results.json",
          0,
          { "d/results.json: is not a plain file", "mine\n../x" } },
        { RUN "run 10 d; echo mine >x; ln -sf ../../x d/tables/summary.csv; run 12 d; $W report d; cat x",
          0,
          { "d/tables/summary.csv: is not a plain file", "mine" } },
        { RUN "run 10 d; mkdir plots; mv d/tables .; ln -s ../plots ../tables d; $W report d; echo $?",
          0,
          { "d/tables: is not a folder", "2\n" } },
        { RUN "run 10 d; echo mine >x; ln -s ../x d/report.html; ln -s ../x d/report.pdf; $W report d; cat x",
          0,
          { "no run of windfirm made it", "mine" } },
        { RUN "echo mine >x; mkdir d; ln -s ../x d/.windfirm.lock; run 10 d; cat x",
          0,
          { "cannot be written", "mine" } },
        { RUN "run 10 d; sed -i 's|tables/sweep.csv\", \"size|../x\", \"size|' d/results.json; $W report d",
          2,
          { "run_files: names a file that is not below the folder" } },
        { RUN "run 10 d; sed -i 's|tables/sweep.csv\", \"size|/etc/passwd\", \"size|' d/results.json; $W "
              "report d",
          2,
          { "run_files: names a file that is not below the folder" } },
        { RUN
          "run 10 d; sed -i 's|tables/sweep.csv\", \"size|tables/shape.csv\", \"size|' d/results.json; $W "
          "report d",
          2,
          { "d/results.json: run_files: names a file that is not below the folder, or one twice" } },
        /* a file without blocks would fill the disk when it is copied */
        { RUN "run 10 d; sed -i '/\"run_files\"/,$d; s/\"status\": \"complete\",/\"status\": \"complete\"}/' "
              "d/results.json; truncate -s 3G d/tables/sweep.csv; $W report d",
          2,
          { "d/tables/sweep.csv: is larger than 2 GB" } },
    };
    CHECK(rows);
}

/* A folder whose files are not of one run is refused by `report`, or marked. */
static void mixtures(void **unused)
{
    (void)unused;
    static const struct row rows[] = {
        { RUN "run 10 a; run 12 b; cp b/tables/summary.csv a/tables; rm a/tables/sweep.csv; $W report a",
          2,
          { "a: files of different runs stand together", "tables/summary.csv is not of this run",
            "tables/sweep.csv is missing" } },
        { RUN "run 10 a; run 12 b; cp b/results.json a; $W report a", 2, { "stand together" } },
        { RUN "PATH=/none $W analyze oak --model culm --wind 10 -q -o a 2>/dev/null; echo >>a/report.html; "
              "PATH=/none $W report a; test -e a/report.html",
          0,
          { "[changed-pages]", "report.html" } },
        /* results of a version that listed no files */
        { RUN "run 10 a; sed -i '/\"run_files\"/,/^ \\]/d; s/ \"status\": \"complete\",/ \"x\": 1/' "
              "a/results.json; PATH=/none $W report a; grep -c 'class=\"status\"' a/report.html; grep "
              "'\"status\": \"unv' a/results.json; run 12 a && PATH=/none $W report a; grep '\"status\": "
              "\"co' a/results.json",
          0,
          { "[not-listed]", "1\n", "unverified", "complete" } },
    };
    CHECK(rows);
}

static void two_at_once(void **unused)
{
    (void)unused;
    static const struct row rows[] = {
        { RUN "mkdir d; exec 9>d/.windfirm.lock; flock 9; run 10 d; echo $?; exec 9>&-; run 10 d; echo $?; "
              "ls -A d",
          0,
          { "d: another run of windfirm writes there now\n1\n", "0\nresults.json\ntables\n" } },
        { RUN "for i in 1 2 3 4 5 6; do run $i d 2>e$i & done; wait; PATH=/none $W report -q d 2>/dev/null; "
              "ls -A d | grep windfirm; cat e? | sort | uniq",
          0,
          { "" } },
        /* stages of dead runs are cleaned, what only looks like one stays */
        { RUN "mkdir -p d/.windfirm-4194999/tables d/.windfirm-x; : >d/.windfirm-4194999/tables/a.csv; : "
              ">d/.windfirm-1; run 10 d && ls -A d",
          0,
          { ".windfirm-1\n.windfirm-x\nresults.json\ntables\n" } },
    };
    CHECK(rows);
}

/* A folder that is a disk of its own, and one whose tables are on another disk. */
static void mount_points(void **unused)
{
    (void)unused;
    if (system("unshare -rm mount -t tmpfs none /mnt 2>/dev/null")) {
        print_message("skipped: no disks can be mounted here (unshare -rm)\n");
        skip();
    }
#define MOUNTED(commands)                                                                                    \
    RUN "export W; mkdir -p d/tables; cat >inside <<'END'\n"                                                 \
        "run() { v=$1; shift; $W analyze oak --model culm --wind $v -q --no-report -o \"$@\"; }\n" commands  \
        "\nEND\nunshare -rm sh inside"
    static const struct row rows[] = {
        { MOUNTED(
              "mount -t tmpfs none d && run 10 d && run 12 d && ls -A d; PATH=/none $W report -q d; echo $?; "
              "grep -c run_files d/results.json; run 10 d --study none; ls -A d | wc -l"),
          0,
          { "results.json\ntables\n", "1\n1\n", "4\n" } },
        { MOUNTED("mount -t tmpfs none d && run 10 d --study none; ls -A d; mountpoint -q d && echo mounted"),
          0,
          { "none", "mounted\n" } },
        { MOUNTED("mount -t tmpfs none d/tables && run 10 d; echo $?; ls -A d d/tables"),
          0,
          { "d/tables/segments.csv: cannot be written: Invalid cross-device "
            "link\n1\nd:\ntables\n\nd/tables:\n" } },
        { MOUNTED("mount -t tmpfs -o size=20k none d && run 10 d; echo $?; ls -A d"),
          0,
          { "No space left on device\n1\n" } },
    };
    CHECK(rows);
}

/* Kill -9 at 20 moments of a run: the folder is of the run before or of this one, or `report` does not take
 * it; and the next run puts it right. */
static void killed(void **unused)
{
    (void)unused;
    static const struct row rows[] = {
        { RUN "sum() { (cd d && cat results.json tables/* 2>/dev/null | sha256sum); }\nexport "
              "SOURCE_DATE_EPOCH=1000000000; start=$(date +%s%N); run 12 d; b=$(sum); span=$((($(date +%s%N) "
              "- start) / 1000000)); run 10 d; a=$(sum)\nfor i in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 "
              "18 19 20; do\nrun 10 d; $W analyze oak --model culm --wind 12 -q --no-report -o d 2>/dev/null "
              "& sleep $(awk \"BEGIN { print $i * $span / 20000 }\")\nkill -9 $! 2>/dev/null; wait $! "
              "2>/dev/null; now=$(sum)\nif [ \"$now\" != \"$a\" ] && [ \"$now\" != \"$b\" ] && ! { $W report "
              "-q d 2>&1 >/dev/null | grep -q .; }; then echo MIXTURE; fi\nrun 10 d || echo STUCK; ls -A d | "
              "grep windfirm; done; echo end",
          0,
          { "end" } },
    };
    CHECK(rows);
    if (strstr(output, "MIXTURE") || strstr(output, "STUCK") || strstr(output, ".windfirm"))
        fail_msg("it printed:\n%s", output);
}

/* Killed by gdb before each move of a file into the folder: all but the first stop leave a mixture. */
static void killed_between_moves(void **unused)
{
    (void)unused;
    if (system("command -v gdb >/dev/null")) {
        print_message("skipped: gdb is not installed\n");
        return;
    }
    static const struct row rows[] = {
        { RUN "for n in 0 1 2 3 4 5; do run 10 d; gdb -q -batch -nx -ex 'set breakpoint pending on' -ex 'set "
              "debuginfod enabled off' -ex 'break renameat' -ex \"ignore 1 $n\" -ex run -ex kill --args $W "
              "analyze oak --model culm --wind 12 -q --no-report -o d >/dev/null 2>&1; ls -A d | grep -c "
              "windfirm; $W report -q d 2>e; echo $? $(grep -c together e); rm -rf d; done",
          0,
          { "2\n0 0\n2\n2 1\n2\n2 1\n2\n2 1\n2\n2 1\n" } },
    };
    CHECK(rows);
}

/* `stop SIGNAL STATE COMMAND...`: run a command and send it a signal as soon as a state is there, however
 * fast the machine is; a command that ends before gets none. The command is not the one in the background: a
 * shell starts those with SIGINT ignored. */
#define STOP                                                                                                 \
    RUN "stop() { s=$1 state=$2; shift 2; rm -f pid; { until [ -s pid ]; do sleep 0.01; done; p=$(cat "      \
        "pid); "                                                                                             \
        "while kill -0 $p && ! eval \"$state\"; do sleep 0.01; done; kill -$s $p; } >/dev/null 2>&1 & sh "   \
        "-c "                                                                                                \
        "'echo $$ >pid; exec \"$@\"' sh \"$@\"; echo code $?; wait; }\n"

/* Ctrl-C: what is finished is put in place and says so; no stage, no child is left. */
static void interrupted(void **unused)
{
    (void)unused;
    static const struct row rows[] = {
        /* the first tree's speeds are printed; its searches and four trees are to come */
        { STOP
          "stop INT 'grep -q ^Oak said' $W compare oak beech ash poplar birch --model broadleaf --wind "
          "5:40:5 --no-report -o d >said; grep ^code said; grep '\"status\": \"int' d/results.json; ls -A d; "
          "PATH=/none $W report d >/dev/null 2>&1; grep -c 'class=\"status\"' d/report.html",
          0,
          { "code 130", "\"status\": \"interrupted\"", "plots\nresults.json\ntables\n1\n" } },
        /* from the stage on signals are noted; 600 frames are to come, and one is always finished */
        { STOP
          "stop TERM 'test -d d/.windfirm-*/tables' $W series oak --model broadleaf --wind 10 --gust cosine "
          "-q --no-report -o d; grep '\"status\": \"int' d/results.json; ls -A d",
          0,
          { "code 143", "interrupted", "plots\nresults.json\ntables\nvtk\n" } },
        /* a part of the wind is written, of 8 GB */
        { STOP
          "stop INT 'find . -name \".g.npy*\" -size +0 | grep -q .' $W wind von-karman --points 30 "
          "--duration 1000000 --stream g.npy >said; grep ^code said; ls -A | grep npy; head -c 100 g.npy | "
          "grep -a -o 'shape.*,'; stat -c %s g.npy",
          0,
          { "code 130\ng.npy\n", "shape" } },
        /* the child is looked for as long as the run lives, and kept by the look that found it;
           a child that has ended and that nobody has waited for (Z) is none */
        { RUN
          "$W analyze oak --model culm --wind 10 -q -o d & p=$!; c=; while [ -z \"$c\" ] && ! grep -q "
          "'^State:.[ZX]' /proc/$p/status; do c=$(pgrep -P $p); done; kill -9 $p; wait $p; for i in 1 2 3 "
          "4 5 6; do sleep 0.5; left=; for k in $c; do grep -q '^State:.[^ZX]' /proc/$k/status 2>/dev/null "
          "&& left=$k; done; [ $left ] || break; done; [ $left ] && echo ORPHAN; [ \"$c\" ] && echo child; "
          "echo end",
          0,
          { "child\nend" } },
    };
    CHECK(rows);
    if (strstr(output, "ORPHAN")) fail_msg("a child lives on:\n%s", output);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names),       cmocka_unit_test(plain_files),
        cmocka_unit_test(lists),       cmocka_unit_test(belongs),
        cmocka_unit_test(links),       cmocka_unit_test(mixtures),
        cmocka_unit_test(two_at_once), cmocka_unit_test(mount_points),
        cmocka_unit_test(killed),      cmocka_unit_test(killed_between_moves),
        cmocka_unit_test(interrupted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
