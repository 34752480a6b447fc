/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_OPTION_H
#define WF_CMD_OPTION_H
/* Options as rows. One row says how an option is typed, what values it takes, what it means, and which member
 * of the command's options struct holds its value. The usage text, the checks, the keys of study files and
 * the values in the struct all come from this row. A file with rows first names the struct that they fill:
 *
 *     #define OPTIONS struct terrain_options
 *     static const struct wf_option options[] = {
 *         NUMBER("--height", height, "LENGTH", LENGTH, "m", 0.1, 500, "10", "above the ground"),
 *         QUIET("print errors only"),
 *         { 0 },
 *     };
 *
 * The struct's first member is `struct wf_args args`. A member that the struct does not have, or that has
 * another type than the row needs, does not compile. */
#include "base/arena.h"
#include "base/units.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* Kind of an option, and the type of the member that holds its value. */
enum wf_option_kind {
    WF_OPTION_FLAG,   /* bool: takes no value                                                              */
    WF_OPTION_TEXT,   /* const char *: any text; NULL when there is neither a value nor a default          */
    WF_OPTION_PATH,   /* const char *: name of a file; one named in a study file is looked for beside it   */
    WF_OPTION_STUDY,  /* const char *: the study file itself                                               */
    WF_OPTION_TEXTS,  /* const char *: texts separated by commas; given again, it adds                     */
    WF_OPTION_CHOICE, /* const char *: one of `choices`, or of the words that `word` returns               */
    WF_OPTION_NUMBER, /* double, SI: a number with or without a unit, low..high; NAN when there is none    */
    WF_OPTION_WHOLE,  /* size_t: a whole number within low..high; has a default                            */
    WF_OPTION_SPEED,  /* double [m/s]: one mean wind: a number like the above, or "beaufort:8"             */
    WF_OPTION_SPEEDS  /* struct wf_speeds: several, "10,15,25", "5:40:1", "36km/h", "cma:typhoon,30"       */
};

struct wf_option {
    const char *name;   /* "--solver"                                                                      */
    const char *letter; /* "-s" or NULL                                                                    */
    enum wf_option_kind kind;
    size_t member;                 /* offset of the value in the command's options struct                  */
    const char *value;             /* word for the value in the usage text, e.g. "FILE"                    */
    const char *initial;           /* default as it would be typed; NULL: none                             */
    enum wf_dimension dimension;   /* of a number or speed                                                 */
    const char *unit;              /* of a plain number and of low and high; NULL: none                    */
    double low, high;              /* allowed, in `unit`                                                   */
    const char *choices;           /* words separated by '|'                                               */
    const char *(*word)(size_t i); /* or the i-th word of a list of rows, NULL after the last              */
    const char *(*meant)(
        const char *text); /* the word that another one means, NULL: none; NULL: no other is */
    size_t averaging;      /* of a speed: offset of its struct wf_averaging (cmd/wind_speed.h)     */
    size_t group; /* offset of the struct of shared options that the member is in (cmd/option_groups.h)    */
    /* Whether the option has no effect with the others as they are; asked when it is given and all are read.
     * Returned in `why`: the words behind "has no effect". NULL: it always has one. */
    bool (*unused)(const void *options, const struct wf_option *o, char *why);
    /* Whether its value is missing or contradicts the others; asked of every row when all are read. Returned
     * in `why`: the words behind the option's name. NULL: never. */
    bool (*wrong)(const void *options, const struct wf_option *o, char *why);
    const char *help;
};

enum { WF_OPTIONS_MAX = 144, WF_WHY = 256 };

/* For `unused`: whether, and why: the text is made when `unused` is true. */
bool wf_option_unused(bool unused, char why[static WF_WHY], const char *fmt, ...)
    __attribute__((format(printf, 3, 4)));

/* Head of every options struct: what does not depend on the command. */
struct wf_args {
    const struct wf_option *option; /* rows, end at name == NULL                                            */
    size_t n;                       /* operands                                                             */
    const char **operand;
    bool quiet;             /* row QUIET                                                            */
    const char *study;      /* row STUDY: name of the study file; NULL: none                        */
    const char *winds_said; /* how winds were converted to 10-min means; NULL: nothing was converted */
    struct wf_wind_note *wind_notes; /* the same by parts (load/scene.h); NULL: none */
    const char **text;          /* by row: as typed, in the study file or the default; NULL: none        */
    bool given[WF_OPTIONS_MAX]; /* by row: typed or in the study file; ask with WF_GIVEN                */
};

struct wf_speeds {
    size_t n;
    double *speed; /* [m/s], ascending, each once */
};

/* Whether an option was typed or stands in the study file, as opposed to its default. `o` points to the
 * options struct; `m` is the member that the option's row names. */
#define WF_GIVEN(o, m) wf_option_given(&(o)->args, (size_t)((const char *)&(o)->m - (const char *)(o)))
bool wf_option_given(const struct wf_args *args, size_t member);

/* Offset of a member of OPTIONS that has this type. */
#define WF_MEMBER(m, type) (offsetof(OPTIONS, m) + _Generic(((OPTIONS *)NULL)->m, type : (size_t)0))
#define WF_ROW(n, k, m, type, ...)                                                                           \
    {                                                                                                        \
        .name = n, .kind = WF_OPTION_##k, .member = WF_MEMBER(m, type), .help = __VA_ARGS__                  \
    }

/* The rows. Arguments: option, member, word for the value, what is allowed, default, help; `.letter = "-s"`
 * may follow the help. */
#define FLAG(n, m, ...) WF_ROW(n, FLAG, m, bool, __VA_ARGS__)
#define QUIET(...) FLAG("--quiet", args.quiet, __VA_ARGS__, .letter = "-q")
#define TEXT(n, m, v, start, ...) WF_ROW(n, TEXT, m, const char *, __VA_ARGS__, .value = v, .initial = start)
#define PATH(n, m, v, start, ...) WF_ROW(n, PATH, m, const char *, __VA_ARGS__, .value = v, .initial = start)
#define TEXTS(n, m, v, ...) WF_ROW(n, TEXTS, m, const char *, __VA_ARGS__, .value = v)
#define CHOICE(n, m, v, list, start, ...)                                                                    \
    WF_ROW(n, CHOICE, m, const char *, __VA_ARGS__, .value = v, .choices = list, .initial = start)
#define WORD(n, m, v, of, start, ...)                                                                        \
    WF_ROW(n, CHOICE, m, const char *, __VA_ARGS__, .value = v, .word = of, .initial = start)
#define WF_NUMERIC(v, dim, u, least, most, start)                                                            \
    .value = v, .dimension = WF_DIM_##dim, .unit = u, .low = least, .high = most, .initial = start
#define NUMBER(n, m, v, dim, u, least, most, start, ...)                                                     \
    WF_ROW(n, NUMBER, m, double, __VA_ARGS__, WF_NUMERIC(v, dim, u, least, most, start))
#define WHOLE(n, m, least, most, start, ...)                                                                 \
    WF_ROW(n, WHOLE, m, size_t, __VA_ARGS__, WF_NUMERIC("NUMBER", NONE, NULL, least, most, start))
/* A wind; `beside` is the member of type struct wf_averaging, whose rows stand beside this one. */
#define SPEED(n, m, beside, least, most, start, ...)                                                         \
    WF_ROW(n, SPEED, m, double, __VA_ARGS__, .averaging = WF_MEMBER(beside, struct wf_averaging),            \
           WF_NUMERIC("SPEED", SPEED, "m/s", least, most, start))
#define SPEEDS(n, m, beside, least, most, ...)                                                               \
    WF_ROW(n, SPEEDS, m, struct wf_speeds, __VA_ARGS__, .averaging = WF_MEMBER(beside, struct wf_averaging), \
           WF_NUMERIC("SPEEDS", SPEED, "m/s", least, most, NULL))
/* Row of a command that takes a study file (cmd/args.c). */
#define STUDY                                                                                                \
    WF_ROW("--study", STUDY, args.study, const char *,                                                       \
           "options from a file, one key an option ('windfirm schema study'); the command line takes "       \
           "precedence",                                                                                     \
           .value = "FILE")

/* Help, allowed values and default of an option as one paragraph; empty without memory. */
enum { WF_OPTION_DOC = 1024 };
void wf_option_text(const struct wf_option *o, char text[static WF_OPTION_DOC]);
/* The words that a choice may be. Returned: how many; `list` holds those of `choices`. */
enum { WF_OPTION_CHOICES = 32 };
size_t wf_option_choices(const struct wf_option *o, const char *word[static WF_OPTION_CHOICES], char *list,
                         size_t size);

/* Mistakes as one text, separated by semicolons and cut where it is full. */
struct wf_sink {
    size_t n;
    char text[600];
};

/* One command line being read, with its study file. Every mistake is reported where it is found and counted;
 * reading goes on, so that all are reported at once. */
struct wf_yaml;
struct wf_reading {
    struct wf_args *args; /* head of the command's options struct */
    const char *command;
    struct wf_arena *arena;
    struct wf_units *units;
    size_t options, mistakes;
    struct wf_yaml *yaml;             /* the study file while it is open; else NULL                        */
    const char *text[WF_OPTIONS_MAX]; /* by row: as typed, else as in the study file, else the default     */
    const char *key[WF_OPTIONS_MAX];  /* by row: key of the study file that gave the text; NULL: no key    */
    bool failed[WF_OPTIONS_MAX];      /* by row: its text was a mistake                                    */
    struct wf_sink *sink;             /* takes the mistakes; NULL: they are printed                        */
    bool complete;
    bool unknown;   /* an option was, in place of which another may be missing */
    bool no_memory; /* it ended while an option was read: no mistake of the user */
};

/* Report a mistake and count it. Given: the key of the study file it belongs to, where file, line and column
 * are printed; or key == NULL and the option as it is to be named on stderr, "" for none. */
void wf_option_mistake(struct wf_reading *r, const char *key, const char *name, const char *fmt, ...)
    __attribute__((format(printf, 4, 5)));
/* Set the member of every row to what it holds without a value. */
void wf_option_clear(struct wf_reading *r);
/* Check the text for row k and set the row's member. A flag takes yes or no. Winds are only kept as text:
 * wf_winds_read sets their members when the other options are known. */
void wf_option_take(struct wf_reading *r, size_t k, const char *text);
/* Where the member of row k is. */
void *wf_option_member(const struct wf_reading *r, size_t k);
/* Read one number of row k; a plain one is in `unit`. Returned: *si, and whether it is within low, in the
 * row's own unit, and the row's high. */
bool wf_option_quantity(struct wf_reading *r, size_t k, const char *text, const char *unit, double low,
                        double *si);
/* The unit behind the number at the start of `text`, blanks skipped; "" for none. NULL: no number there. */
const char *wf_option_unit(const char *text);
/* Print to the terminal, to stdout or stderr: all text that this room prints goes through here. A name or a
 * path may hold anything; what would act on a terminal is shown escaped (base/text.h), and so is a line end
 * that is not one of `fmt`. Returned: bytes written, -1 on failure. */
int wf_show(FILE *to, const char *fmt, ...) __attribute__((format(printf, 2, 3)));
/* Turn what is printed to stdout into a system of units (out/page_units.h) from now on; lines are held back
 * until they are whole. Given: the system, or NULL: what is held back is printed, and no more is turned. */
void wf_show_in(const char *system);
/* The system that is set; NULL: none. */
const char *wf_show_units(void);
/* Say what has a translation (out/tongue.h) in a language from now on: "zh"; "en" changes nothing. */
void wf_show_language(const char *language);
/* A species' name in that language; NULL: it has none. To be called before the first thread is started. */
void wf_show_name(const char *name, const char *own);
struct wf_said;
/* A sentence by parts in the language that is set. Returned: NULL in English, without a translation or
 * memory. */
char *wf_show_words(const struct wf_said *said, struct wf_arena *a);
/* Print a text of this program as it is, line ends included; it holds no names. */
int wf_show_text(FILE *to, const char *text);
#endif
