/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/file.h"
#include "close.h"
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* FIPS 180-4 examples and NIST's long message; the lengths around the block's end. */
static void published(void **state)
{
    (void)state;
    static const struct {
        const char *text, *digest;
    } known[] = {
        { "", "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855" },
        { "abc", "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad" },
        { "abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq",
          "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1" },
        { "abcdefghbcdefghicdefghijdefghijkefghijklfghijklmghijklmnhijklmnoijklmnopjklmnopqklmnopqrlmnopqrsmn"
          "opqrstnopqrstu",
          "cf5b16a778af8380036ce59e7b0492370b249b11e8f07a51afac45037afee9d1" },
    };
    char text[WF_SHA256_TEXT];
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        wf_sha256(known[i].text, strlen(known[i].text), text);
        assert_string_equal(text, known[i].digest);
    }
}

static void million(void **state)
{
    (void)state;
    size_t n = 1000000;
    char *a = malloc(n), text[WF_SHA256_TEXT];
    assert_non_null(a);
    memset(a, 'a', n);
    wf_sha256(a, n, text);
    assert_string_equal(text, "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
    free(a);
}

static void file(void **state)
{
    (void)state;
    char path[] = "/tmp/windfirm-sha-XXXXXX", text[WF_SHA256_TEXT];
    struct wf_err e = { 0 };
    int fd = mkstemp(path);
    assert_true(fd >= 0);
    assert_int_equal(write(fd, "abc", 3), 3);
    close(fd);
    assert_int_equal(wf_sha256_file(path, &(struct wf_arena){ 0 }, text, &e), WF_OK);
    assert_string_equal(text, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    unlink(path);
    assert_int_equal(wf_sha256_file(path, &(struct wf_arena){ 0 }, text, &e), WF_EINPUT);
    assert_non_null(strstr(e.text, path));
}

static void folder(void **state)
{
    (void)state;
    char text[WF_SHA256_TEXT];
    struct wf_err e = { 0 };
    assert_int_equal(wf_sha256_file("/tmp", &(struct wf_arena){ 0 }, text, &e), WF_EINPUT);
    assert_non_null(strstr(e.text, "/tmp: cannot be read"));
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(published), cmocka_unit_test(million),
                                        cmocka_unit_test(file), cmocka_unit_test(folder) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
