#include "out/page.h"
#include "base/file.h"
#include "out/program.h"
#include <string.h>

/* WeasyPrint goes on after a fault and still ends with status 0: look for its word and for a whole file. */
enum wf_status wf_page_print(const char *html, const char *path, struct wf_err *e)
{
    char said[WF_SAID_MAX], head[5] = "", tail[8] = "";
    struct wf_file f = { 0 };
    enum wf_status code = wf_file_begin(&f, path, e);
    if (code) return code;
    const char *const argv[] = { "weasyprint", "--encoding", "utf-8", html, f.temporary, NULL };
    code = wf_program_run(argv, "weasyprint", said, e);
    if (!code && strstr(said, "ERROR")) code = wf_fail(e, WF_EOUTPUT, "%s: WeasyPrint says: %s", path, said);
    FILE *pdf = code ? NULL : fopen(f.temporary, "rb");
    if (pdf) {
        size_t n = fread(head, 1, 4, pdf);
        head[n] = '\0';
        n = fseek(pdf, -7, SEEK_END) ? 0 : fread(tail, 1, 7, pdf);
        tail[n] = '\0';
        fclose(pdf);
    }
    if (!code && (strcmp(head, "%PDF") != 0 || !strstr(tail, "%%EOF")))
        code = wf_fail(e, WF_EOUTPUT, "%s: the file is not complete (is the disk full?)", path);
    if (!code) code = wf_file_commit(&f, e);
    wf_file_abandon(&f);
    return code;
}
