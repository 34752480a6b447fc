#include "cmd/args.h"
#include <string.h>

/* One paragraph from column `left` (where the cursor stands) to column 80, broken between words. */
static void paragraph(FILE *to, const char *text, int left)
{
    int column = left;
    while (*text) {
        int word = (int)strcspn(text, " ");
        if (column > left && column + 1 + word > 80) {
            fprintf(to, "\n%*s", left, "");
            column = left;
        } else if (column > left) {
            fputc(' ', to);
            column++;
        }
        fprintf(to, "%.*s", word, text);
        column += word;
        text += word;
        while (*text == ' ') text++;
    }
    fputc('\n', to);
}

void wf_option_text(const struct wf_option *o, FILE *to)
{
    const char *unit = o->unit ? o->unit : "", *word[WF_CHOICES_MAX];
    char list[512];
    fputs(o->help, to);
    if (o->kind == WF_OPTION_CHOICE) {
        size_t n = wf_args_choices(o, word, list, sizeof list);
        for (size_t i = 0; i < n; i++) fprintf(to, "%s%s", i ? ", " : ": ", word[i]);
    }
    bool wind = o->kind == WF_OPTION_SPEED || o->kind == WF_OPTION_SPEEDS;
    if (o->kind == WF_OPTION_NUMBER || o->kind == WF_OPTION_WHOLE || wind)
        fprintf(to, " (%.6g..%.6g%s%s)", o->low, o->high, *unit ? " " : "", unit);
    if (wind) fputs("; or a grade: beaufort:8, cma:typhoon, hko:typhoon", to);
    if (o->initial)
        fprintf(to, " [%s%s%s]", o->initial, o->kind != WF_OPTION_CHOICE && *unit ? " " : "",
                o->kind != WF_OPTION_CHOICE ? unit : "");
}

static void option_print(FILE *to, const struct wf_option *o)
{
    char text[1024] = "";
    FILE *body = fmemopen(text, sizeof text, "w");
    if (!body) return;
    wf_option_text(o, body);
    fclose(body);
    int shown = fprintf(to, "  %s%s%s%s%s", o->letter ? o->letter : "", o->letter ? ", " : "", o->name,
                        o->value ? " " : "", o->value ? o->value : "");
    if (shown > 27) shown = fprintf(to, "\n") - 1;
    fprintf(to, "%*s", 28 - shown, "");
    paragraph(to, text, 28);
}

void wf_usage_print(FILE *to, const char *command, const struct wf_option *option, const char *about)
{
    const struct wf_command *c = wf_commands;
    while (c->name && strcmp(c->name, command) != 0) c++;
    fprintf(to, "Usage: windfirm %s %s\n\n", command, c->name ? c->operands : "");
    if (c->name) paragraph(to, c->summary, 0);
    if (about) {
        fputc('\n', to);
        while (
            *about) { /* paragraphs are parted by newlines; a line that starts with a blank stays as it is */
            char line[1000];
            size_t length = strcspn(about, "\n");
            snprintf(line, sizeof line, "%.*s", (int)length, about);
            if (line[0] == ' ' || !line[0])
                fprintf(to, "%s\n", line);
            else
                paragraph(to, line, 0);
            about += length + (about[length] == '\n');
        }
    }
    if (option && option->name) fprintf(to, "\nOptions (default in brackets):\n");
    for (const struct wf_option *o = option; o && o->name; o++) option_print(to, o);
}
