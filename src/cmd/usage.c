/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/usage.h"
#include "base/file.h"
#include "base/said.h"
#include "cmd/commands.h"
#include <string.h>

static const struct wf_command *find_command(const char *name)
{
    const struct wf_command *c = wf_commands;
    while (c->name && strcmp(c->name, name) != 0) c++;
    return c;
}

/* ---- For a terminal ---- */

/* Bytes of the character at `text`. */
static size_t character(const char *text)
{
    size_t n = 1;
    while (((unsigned char)text[n] & 0xC0) == 0x80) n++;
    return n;
}

/* A character that is as wide as two letters, and behind which a line may end. */
static bool is_wide(const char *text) { return (unsigned char)*text >= 0xE3; }

/* Does a line not begin with this character? */
static bool stays_behind(const char *text)
{
    static const char *const mark[] = { "，", "。", "；", "：", "、", "）", "”", "》", "…", ")", "]", ":" };
    for (size_t i = 0; i < sizeof mark / sizeof *mark; i++)
        if (!strncmp(text, mark[i], strlen(mark[i]))) return true;
    return false;
}

/* What stands together at `text`: a word, or a wide character with the marks behind it. Returned: its bytes
 * and in *columns its width. */
static size_t piece_of_line(const char *text, int *columns)
{
    size_t n = 0;
    bool wide = false, before = false;
    for (*columns = 0; text[n] && text[n] != ' '; before = wide, n += character(text + n)) {
        wide = is_wide(text + n);
        if (n && (wide || before) && !stays_behind(text + n)) break;
        *columns += wide ? 2 : 1;
    }
    return n;
}

/* One paragraph of the program's own from column `left` (where the cursor stands) to column 80, broken
 * between words. */
static void print_paragraph(FILE *to, const char *text, int left)
{
    int column = left, wide = 0;
    for (bool blank = false; *text; blank = *text == ' ', text += strspn(text, " ")) {
        size_t n = piece_of_line(text, &wide);
        if (column > left && column + blank + wide > 80) {
            fprintf(to, "\n%*s", left, "");
            column = left;
        } else if (blank) {
            fputc(' ', to);
            column++;
        }
        fprintf(to, "%.*s", (int)n, text);
        column += wide;
        text += n;
    }
    fputc('\n', to);
}

/* The same in the language of the terminal. */
static void print_said(FILE *to, const char *text, int left)
{
    struct wf_arena a = { 0 };
    const struct wf_said said = { .message = "{1}", .n = 1, .arg = { text } };
    const char *own = wf_show_words(&said, &a);
    print_paragraph(to, own ? own : text, left);
    wf_arena_free(&a);
}

static void print_option(FILE *to, const struct wf_option *o)
{
    char text[WF_OPTION_DOC];
    wf_option_text(o, text);
    int shown = fprintf(to, "  %s%s%s%s%s", o->letter ? o->letter : "", o->letter ? ", " : "", o->name,
                        o->value ? " " : "", o->value ? o->value : "");
    if (shown > 27) shown = fprintf(to, "\n") - 1;
    fprintf(to, "%*s", 28 - shown, "");
    print_paragraph(to, text, 28);
}

/* Newlines separate paragraphs; a line that starts with a blank is printed unchanged. */
static void print_about(FILE *to, const char *about)
{
    while (*about) {
        char line[1000];
        size_t length = strcspn(about, "\n");
        snprintf(line, sizeof line, "%.*s", (int)length, about);
        if (line[0] == ' ' || !line[0])
            fprintf(to, "%s\n", line);
        else
            print_said(to, line, 0);
        about += length + (about[length] == '\n');
    }
}

/* The page shown by --help, made from the rows. */
static void print_usage(FILE *to, const char *command, const struct wf_option *option, const char *about)
{
    const struct wf_command *c = find_command(command);
    wf_show(to, "Usage: windfirm");
    fprintf(to, " %s %s\n\n", command, c->name ? c->operands : "");
    if (c->name) print_said(to, c->summary, 0);
    if (about) {
        fputc('\n', to);
        print_about(to, about);
    }
    if (option && option->name) wf_show(to, "\nOptions (default in brackets):\n");
    for (const struct wf_option *o = option; o && o->name; o++) print_option(to, o);
}

/* ---- A manual page (man(7) macros) ---- */

/* Text as troff prints it unchanged: '\' and '-' are written as their escapes. Within one call a line end
 * stays one, and a line that would begin with a control character of troff has a mark of no width before it.
 */
static void put_roff(FILE *to, const char *text, size_t n)
{
    bool first = true;
    for (size_t i = 0; i < n; i++) {
        char c = text[i];
        if (first && (c == '.' || c == '\'')) fputs("\\&", to);
        first = c == '\n';
        if (c == '\\' || c == '-')
            fputs(c == '-' ? "\\-" : "\\e", to);
        else
            fputc(c, to);
    }
}

static void put_roff_text(FILE *to, const char *text) { put_roff(to, text, strlen(text)); }

/* The paragraphs of a command's page; lines that begin with a blank are kept as they are. */
static void man_about(FILE *to, const char *about)
{
    bool kept = false;
    while (*about) {
        size_t n = strcspn(about, "\n");
        bool keep = n && about[0] == ' ';
        if (keep != kept) fputs(keep ? ".PP\n.nf\n" : ".fi\n", to);
        if (!n || (kept && !keep)) fputs(".PP\n", to);
        if (n) put_roff(to, about, n), fputs("\n", to);
        if (n && !keep) fputs(".br\n", to);
        kept = keep;
        about += n + (about[n] == '\n');
    }
    if (kept) fputs(".fi\n", to);
}

static void man_option(FILE *to, const struct wf_option *o)
{
    char text[WF_OPTION_DOC];
    wf_option_text(o, text);
    fputs(".TP\n", to);
    if (o->letter) fputs("\\fB", to), put_roff_text(to, o->letter), fputs("\\fR, ", to);
    fputs("\\fB", to), put_roff_text(to, o->name), fputs("\\fR", to);
    if (o->value) fputs(" \\fI", to), put_roff_text(to, o->value), fputs("\\fR", to);
    fputs("\n", to);
    put_roff_text(to, text);
    fputs("\n", to);
}

static void print_manual(FILE *to, const char *command, const struct wf_option *option, const char *about)
{
    const struct wf_command *c = find_command(command);
    fprintf(to, ".TH WINDFIRM\\-%s 1 \"\" \"windfirm %s\" \"windfirm\"\n.SH NAME\nwindfirm\\-%s \\- ",
            command, WF_VERSION, command);
    if (c->name) put_roff_text(to, c->summary);
    fprintf(to, "\n.SH SYNOPSIS\n.B windfirm %s\n", command);
    if (c->name) put_roff_text(to, c->operands);
    fputs("\n", to);
    if (about) fputs(".SH DESCRIPTION\n", to), man_about(to, about);
    if (option && option->name) fputs(".SH OPTIONS\nDefaults are in brackets.\n", to);
    for (const struct wf_option *o = option; o && o->name; o++) man_option(to, o);
    fputs(".SH EXIT STATUS\n0: done; 1: the run failed; 2: usage or input is wrong, every mistake is named.\n"
          ".SH SEE ALSO\n.BR windfirm (1)\n",
          to);
}

/* ---- Words for the shell that completes a line ---- */

/* One line an option: its name, the kind of its value (none, file, word, other) and the words allowed,
 * separated by tabs. */
static void print_words(FILE *to, const char *command, const struct wf_option *option, const char *about)
{
    (void)command, (void)about;
    for (const struct wf_option *o = option; o && o->name; o++) {
        char list[WF_OPTION_DOC];
        const char *word[WF_OPTION_CHOICES];
        size_t n = o->kind == WF_OPTION_CHOICE ? wf_option_choices(o, word, list, sizeof list) : 0;
        bool file = o->kind == WF_OPTION_PATH || o->kind == WF_OPTION_STUDY;
        const char *kind = o->kind == WF_OPTION_FLAG ? "none" : file ? "file" : n ? "word" : "other";
        wf_show(to, "%s\t%s\t", o->name, kind);
        for (size_t i = 0; i < n; i++) wf_show(to, "%s%s", i ? " " : "", word[i]);
        wf_show(to, "\n");
    }
    wf_show(to, "--help\tnone\t\n");
}

/* ---- All commands ---- */

static void overview_for_terminal(FILE *to)
{
    wf_show(to,
            "windfirm %s: what wind does to a tree\n\nUsage: windfirm COMMAND [argument...]\n\nCommands:\n",
            WF_VERSION);
    for (const struct wf_command *c = wf_commands; c->name; c++)
        fprintf(to, "  %-13s ", c->name), print_said(to, c->summary, 16);
    wf_show(to, "\n'windfirm COMMAND --help' lists a command's arguments, options, units and defaults.\n"
                "'windfirm --version' prints the version.\n");
}

static void overview_manual(FILE *to)
{
    fprintf(
        to,
        ".TH WINDFIRM 1 \"\" \"windfirm %s\" \"windfirm\"\n.SH NAME\nwindfirm \\- what wind does to a tree\n"
        ".SH SYNOPSIS\n.B windfirm\n.I COMMAND\n[argument...]\n.SH COMMANDS\n",
        WF_VERSION);
    for (const struct wf_command *c = wf_commands; c->name; c++) {
        fprintf(to, ".TP\n.BR windfirm\\-%s (1)\n", c->name);
        put_roff_text(to, c->summary);
        fputs("\n", to);
    }
    fputs(".SH ENVIRONMENT\n.TP\n.B WINDFIRM_SHARE\nfolder of the species, models, reports and validation "
          "cases that are "
          "used in place of the installed ones\n",
          to);
}

/* One line a name: a command, a shipped table of a species or a shipped model. */
static void overview_words(FILE *to)
{
    static const char *const room[] = { "species", "models" };
    struct wf_arena a = { 0 };
    for (const struct wf_command *c = wf_commands; c->name; c++) wf_show(to, "%s\tcommand\n", c->name);
    for (size_t r = 0; r < sizeof room / sizeof *room; r++) {
        const char **name;
        size_t n = wf_shipped_names(wf_share(), room[r], &a, &name);
        for (size_t i = 0; i < n; i++) wf_show(to, "%s\t%s\n", name[i], room[r]);
    }
    wf_arena_free(&a);
}

void wf_usage_language(int argc, char **argv)
{
    for (int i = 1; i < argc && strcmp(argv[i], "--") != 0; i++) {
        const char *value = strncmp(argv[i], "--lang=", 7) ? NULL : argv[i] + 7;
        if (!strcmp(argv[i], "--lang") && i + 1 < argc) value = argv[i + 1];
        if (value && !strcmp(value, "zh")) wf_show_language(value);
    }
}

bool wf_usage_overview(FILE *to, const char *word)
{
    static const struct {
        const char *word;
        void (*print)(FILE *to);
    } form[] = { { "--help", overview_for_terminal },
                 { "-h", overview_for_terminal },
                 { "--help=man", overview_manual },
                 { "--help=words", overview_words } };
    for (size_t i = 0; i < sizeof form / sizeof *form; i++)
        if (strcmp(form[i].word, word) == 0) return form[i].print(to), true;
    return false;
}

const struct wf_usage_form *wf_usage_form(const char *word)
{
    static const struct wf_usage_form form[] = {
        { "--help", print_usage },
        { "-h", print_usage },
        { "--help=man", print_manual },
        { "--help=words", print_words },
        { 0 },
    };
    const struct wf_usage_form *f = form;
    while (f->word && strcmp(f->word, word) != 0) f++;
    return f->word ? f : NULL;
}
