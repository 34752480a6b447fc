/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Files appear complete or not at all; reading refuses what cannot be used. */
#include "base/file.h"
#include "close.h"
#include "scratch.h"
#include <dirent.h>
#include <sys/stat.h>

static size_t entries(const char *folder)
{
    size_t n = 0;
    DIR *d = opendir(folder);
    assert_non_null(d);
    while (readdir(d)) n++;
    closedir(d);
    return n - 2;
}

static void assert_holds(const char *path, const char *text)
{
    struct wf_arena a = { 0 };
    struct wf_err e = { 0 };
    struct wf_bytes b;
    assert_int_equal(wf_file_read(path, &a, &b, &e), WF_OK);
    assert_int_equal(b.size, strlen(text));
    assert_string_equal(b.data, text);
    wf_arena_free(&a);
}

static void a_file_is_replaced_at_the_commit(void **state)
{
    (void)state;
    struct scratch s;
    struct wf_file f;
    struct wf_err e = { 0 };
    struct stat mode;
    scratch_write(&s, "old", 3);
    assert_int_equal(wf_file_begin(&f, s.path, &e), WF_OK);
    assert_true(fputs("new", f.stream) >= 0);
    assert_holds(s.path, "old");
    assert_int_equal(entries(s.folder), 2);
    assert_int_equal(wf_file_commit(&f, &e), WF_OK);
    assert_holds(s.path, "new");
    assert_int_equal(entries(s.folder), 1);
    mode_t mask = umask(0);
    umask(mask);
    assert_int_equal(stat(s.path, &mode), 0);
    assert_int_equal(mode.st_mode & 0777, 0666 & ~mask);
    wf_file_abandon(&f);
    assert_holds(s.path, "new");
    scratch_remove(&s);
}

static void an_abandoned_file_leaves_the_old_one(void **state)
{
    (void)state;
    struct scratch s;
    struct wf_file f;
    struct wf_err e = { 0 };
    scratch_write(&s, "old", 3);
    assert_int_equal(wf_file_begin(&f, s.path, &e), WF_OK);
    assert_true(fputs("half", f.stream) >= 0);
    wf_file_abandon(&f);
    wf_file_abandon(&f);
    assert_holds(s.path, "old");
    assert_int_equal(entries(s.folder), 1);
    assert_int_equal(wf_file_commit(&f, &e), WF_EINTERNAL);
    scratch_remove(&s);
}

static void writing_says_why_not(void **state)
{
    (void)state;
    struct wf_file f;
    struct wf_err e = { 0 };
    assert_int_equal(wf_file_begin(&f, "/tmp", &e), WF_EOUTPUT);
    assert_string_equal(e.text, "/tmp: is a folder; a file is to be written there");
    e = (struct wf_err){ 0 };
    assert_int_equal(wf_file_begin(&f, "/tmp/no-such-folder-here/x", &e), WF_EOUTPUT);
    assert_string_equal(e.text, "/tmp/no-such-folder-here/x: cannot be written: No such file or directory");
    e = (struct wf_err){ 0 };
    char *name = malloc(6000);
    memset(name, 'a', 5999);
    name[5999] = '\0';
    assert_int_equal(wf_file_begin(&f, name, &e), WF_EOUTPUT);
    assert_non_null(strstr(e.text, "the name is too long"));
    free(name);
}

/* A full disk is met at the latest when the file is committed. */
static void a_full_device_is_noticed(void **state)
{
    (void)state;
    struct wf_file f;
    struct wf_err e = { 0 };
    assert_int_equal(wf_file_begin(&f, "/dev/full", &e), WF_OK);
    assert_true(fputs("lost", f.stream) >= 0);
    assert_int_equal(wf_file_commit(&f, &e), WF_EOUTPUT);
    assert_string_equal(e.text, "/dev/full: cannot be written: No space left on device");
    e = (struct wf_err){ 0 };
    assert_int_equal(wf_file_begin(&f, "/dev/null", &e), WF_OK);
    assert_int_equal(wf_file_commit(&f, &e), WF_OK);
    assert_int_equal(access("/dev/null", W_OK), 0);
}

static void folders_are_made(void **state)
{
    (void)state;
    struct scratch s;
    struct wf_err e = { 0 };
    char path[256];
    scratch_write(&s, "x", 1);
    snprintf(path, sizeof path, "%s/a//b/c/", s.folder);
    assert_int_equal(wf_mkdirs(path, &e), WF_OK);
    assert_int_equal(wf_mkdirs(path, &e), WF_OK);
    struct stat st;
    assert_int_equal(stat(path, &st), 0);
    assert_true(S_ISDIR(st.st_mode));
    snprintf(path, sizeof path, "%s/file/below", s.folder);
    assert_int_equal(wf_mkdirs(path, &e), WF_EOUTPUT);
    assert_non_null(strstr(e.text, "/file: is a file, a folder is needed"));
    e = (struct wf_err){ 0 };
    assert_int_equal(wf_mkdirs("", &e), WF_EOUTPUT);
    e = (struct wf_err){ 0 };
    assert_int_equal(wf_mkdirs("/proc/nothing", &e), WF_EOUTPUT);
    static const char *const made[] = { "/a/b/c", "/a/b", "/a" };
    for (int i = 0; i < 3; i++) {
        snprintf(path, sizeof path, "%s%s", s.folder, made[i]);
        assert_int_equal(rmdir(path), 0);
    }
    scratch_remove(&s);
}

static void reading_says_why_not(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_bytes b;
    static const struct {
        const char *path, *text;
    } bad[] = {
        { "/tmp", "/tmp: is a folder, a file was expected" },
        { "/tmp/no-such-file-here", "/tmp/no-such-file-here: cannot be read: there is no such file" },
        { "", ": cannot be read: there is no such file" },
        { "tests/close.h/x", "tests/close.h/x: cannot be read: Not a directory" },
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        struct wf_err e = { 0 };
        assert_int_equal(wf_file_read_text(bad[i].path, &a, &b, &e), WF_EINPUT);
        assert_string_equal(e.text, bad[i].text);
        assert_int_equal(wf_file_read_text(bad[i].path, &a, &b, NULL), WF_EINPUT);
    }
    wf_arena_free(&a);
}

static void a_too_large_file_is_refused_unread(void **state)
{
    (void)state;
    struct scratch s;
    struct wf_arena a = { .limit = 1 };
    struct wf_bytes b;
    struct wf_err e = { 0 };
    scratch_write(&s, "x", 1);
    assert_int_equal(truncate(s.path, 257L * 1024 * 1024), 0);
    assert_int_equal(wf_file_read(s.path, &a, &b, &e), WF_EINPUT);
    assert_non_null(strstr(e.text, ": is larger than 256 MB"));
    wf_arena_free(&a);
    scratch_remove(&s);
}

/* A device tells no size: the reader must find the end by itself. */
static void a_source_without_a_size_is_read_whole(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_bytes b;
    struct wf_err e = { 0 };
    assert_int_equal(wf_file_read("/proc/self/maps", &a, &b, &e), WF_OK);
    assert_true(b.size > 500);
    assert_int_equal(strlen(b.data), b.size);
    e = (struct wf_err){ 0 };
    wf_arena_free(&a);
    for (size_t limit = 1; limit < 60; limit++) {
        struct wf_arena small = { .limit = limit };
        e = (struct wf_err){ 0 };
        assert_int_equal(wf_file_read("/proc/self/maps", &small, &b, &e), WF_ENOMEM);
        wf_arena_free(&small);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_file_is_replaced_at_the_commit),
        cmocka_unit_test(an_abandoned_file_leaves_the_old_one),
        cmocka_unit_test(writing_says_why_not),
        cmocka_unit_test(a_full_device_is_noticed),
        cmocka_unit_test(folders_are_made),
        cmocka_unit_test(reading_says_why_not),
        cmocka_unit_test(a_too_large_file_is_refused_unread),
        cmocka_unit_test(a_source_without_a_size_is_read_whole),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
