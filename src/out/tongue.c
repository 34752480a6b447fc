/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/tongue.h"
#include "base/file.h"
#include "base/said.h"
#include "out/program.h"
#include "out/xml.h"
#include <ctype.h>
#include <libxml/hash.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct wf_tongue {
    bool english;
    struct wf_arena arena;
    xmlHashTable *words; /* by the English text */
    xmlHashTable *named; /* names, by their other form */
    size_t templates, room;
    struct template *template; /* texts with arguments, for what was put together elsewhere */
};

/* "{1} m is below {2} m": an English text with arguments, and its translation. */
struct template
{
    const char *english, *own;
    size_t letters; /* of the text, without arguments */
};

static const xmlNode *child(const xmlNode *of, const char *name)
{
    for (const xmlNode *n = of->children; n; n = n->next)
        if (n->type == XML_ELEMENT_NODE && !xmlStrcmp(n->name, BAD_CAST name)) return n;
    return NULL;
}

/* The text of an element, in the arena. */
static char *text_of(const xmlNode *n, struct wf_arena *a)
{
    xmlChar *text = n ? xmlNodeGetContent(n) : NULL;
    char *copy = text ? wf_arena_text(a, (const char *)text) : NULL;
    xmlFree(text);
    return copy;
}

static void add(struct wf_tongue *t, const char *english, const char *own)
{
    if (english && own && *own) (void)xmlHashAddEntry(t->words, BAD_CAST english, (void *)own);
}

/* Letters outside of the arguments; 0 where two arguments stand side by side, of which none can be told. */
static size_t letters_of(const char *english)
{
    size_t n = 0;
    if (strstr(english, "}{")) return 0;
    for (const char *p = english; *p; p++) n += isalpha((unsigned char)*p) != 0;
    return n;
}

/* Keep a text with arguments, if it says enough to be known by. */
static void add_template(struct wf_tongue *t, const char *english, const char *own)
{
    enum { LEAST = 8 };
    if (!english || !own || !strchr(english, '{') || letters_of(english) < LEAST) return;
    if (t->templates == t->room) {
        size_t room = t->room ? 2 * t->room : 512;
        struct template *more = realloc(t->template, room * sizeof *more);
        if (!more) return;
        t->template = more, t->room = room;
    }
    t->template[t->templates++] = (struct template){ english, own, letters_of(english) };
}

/* "Density, green" within a sentence: "density". */
static void within_sentence(char *text)
{
    bool name = !strncmp(text, "Young", 5) || !strncmp(text, "Poisson", 7) || !strncmp(text, "Vogel", 5);
    if (!name) text[0] = (char)tolower((unsigned char)text[0]);
    text[strcspn(text, ",")] = '\0';
}

static void add_message(struct wf_tongue *t, const char *english, const char *own)
{
    add(t, english, own);
    add_template(t, english, own);
}

/* A row of the catalogue, or of the strings the key of a quantity or of a name that results have. */
static void add_row(struct wf_tongue *t, const xmlNode *row)
{
    const xmlNode *own = child(row, t->english ? "en" : "zh");
    if (!xmlStrcmp(row->name, BAD_CAST "m") && !t->english)
        add_message(t, text_of(child(row, "en"), &t->arena), text_of(own, &t->arena));
    bool quantity = !xmlStrcmp(row->name, BAD_CAST "q");
    if (!quantity && xmlStrcmp(row->name, BAD_CAST "k")) return;
    xmlChar *id = xmlGetProp(row, BAD_CAST "id");
    char *key = id ? wf_arena_text(&t->arena, (const char *)id) : NULL, *text = text_of(own, &t->arena);
    xmlFree(id);
    if (quantity && key && text && t->english) within_sentence(text);
    add(t, key, text);
}

static enum wf_status read_words(struct wf_tongue *t, const char *name, struct wf_err *e)
{
    char path[WF_PATH_MAX];
    xmlDoc *doc = NULL;
    enum wf_status s = wf_report_asset(name, path, sizeof path, e);
    if (!s) s = wf_xml_read(path, &doc, e);
    if (s) return s;
    const xmlNode *root = xmlDocGetRootElement(doc);
    for (const xmlNode *row = root ? root->children : NULL; row; row = row->next)
        if (row->type == XML_ELEMENT_NODE) add_row(t, row);
    xmlFreeDoc(doc);
    return WF_OK;
}

enum wf_status wf_tongue_open(const char *language, struct wf_tongue **out, struct wf_err *e)
{
    struct wf_tongue *t = calloc(1, sizeof *t);
    *out = NULL;
    if (!t || !(t->words = xmlHashCreate(1024)) || !(t->named = xmlHashCreate(16))) {
        if (t) xmlHashFree(t->words, NULL);
        free(t);
        return wf_fail(e, WF_ENOMEM, "no memory for the catalogue of a language");
    }
    t->english = !strcmp(language, "en");
    enum wf_status s = read_words(t, "strings.xml", e);
    if (!s && !t->english) s = read_words(t, "messages.xml", e);
    if (s)
        wf_tongue_close(t);
    else
        *out = t;
    return s;
}

void wf_tongue_close(struct wf_tongue *t)
{
    if (!t) return;
    xmlHashFree(t->words, NULL);
    xmlHashFree(t->named, NULL);
    free(t->template);
    wf_arena_free(&t->arena);
    free(t);
}

/* A name with its English form behind: two species that Chinese calls by one name. */
static void tell_apart(struct wf_tongue *t, const char *name, const char *own)
{
    char *both = wf_arena_print(&t->arena, "%s（%s）", own, name);
    if (both) (void)xmlHashUpdateEntry(t->words, BAD_CAST name, both, NULL);
}

void wf_tongue_name(struct wf_tongue *t, const char *name, const char *own)
{
    if (t->english || !name || !own) return;
    const char *other = xmlHashLookup(t->named, BAD_CAST own);
    char *kept = wf_arena_text(&t->arena, name);
    if (!other) {
        add(t, kept, wf_arena_text(&t->arena, own));
        if (kept) (void)xmlHashAddEntry(t->named, BAD_CAST own, kept);
    } else if (strcmp(other, name) != 0) {
        tell_apart(t, other, own);
        tell_apart(t, name, own);
    }
}

static const char *found(const struct wf_tongue *t, const char *english)
{
    return xmlHashLookup(t->words, BAD_CAST english);
}

const char *wf_tongue_text(const struct wf_tongue *t, const char *english)
{
    const char *own = t && english ? found(t, english) : NULL;
    return own ? own : english;
}

static const char *piece(const struct wf_tongue *t, const char *text, struct wf_arena *a);

/* Does a number begin at `p`, that is no part of a word or of a unit? */
static bool begins_number(const char *text, const char *p)
{
    char before = p > text ? p[-1] : ' ';
    return isdigit((unsigned char)*p) && !isalnum((unsigned char)before) && !strchr("^_.", before);
}

static const char *end_of_number(const char *p)
{
    const char *end = p + strspn(p, "0123456789");
    if (*end == '.' && isdigit((unsigned char)end[1])) end += 1 + strspn(end + 1, "0123456789");
    return isalpha((unsigned char)*end) ? p : end;
}

/* A text of the user's files by parts: its numbers are the arguments. false: there are too many, or no
 * memory. */
static bool numbers_apart(const char *text, struct wf_arena *a, struct wf_said *out)
{
    char *message = WF_TAKE(a, 3 * strlen(text) + 8, char), *to = message;
    *out = (struct wf_said){ .message = message };
    for (const char *p = text; message && *p;) {
        const char *end = begins_number(text, p) ? end_of_number(p) : p;
        if (end == p) {
            do *to++ = *p++;
            while (isdigit((unsigned char)*p) && !begins_number(text, p));
            continue;
        }
        if (out->n == WF_SAID_MOST || !(out->arg[out->n++] = wf_arena_print(a, "%.*s", (int)(end - p), p)))
            return false;
        to += sprintf(to, "{%zu}", out->n);
        p = end;
    }
    return message != NULL;
}

/* A text whose catalogue entry has {1} for its numbers. Returned: NULL where there is none. */
static const char *with_numbers(const struct wf_tongue *t, const char *text, struct wf_arena *a)
{
    struct wf_said said;
    const char *own = found(t, text);
    if (own) return own;
    own = numbers_apart(text, a, &said) ? found(t, said.message) : NULL;
    return own ? wf_said_put(a, own, said.arg, said.n) : NULL;
}

/* Notes are clauses. Each needs a translation; a note is not half translated. */
static const struct clause {
    const char *english, *own;
} clauses[] = { { "; ", "；" }, { ". ", "。" }, { ": ", "：" } };

static const char *note(const struct wf_tongue *t, const char *text, size_t level, struct wf_arena *a)
{
    size_t n = strlen(text);
    bool ends = n && text[n - 1] == '.';
    const char *own = with_numbers(t, text, a);
    if (own) return own;
    if (ends) {
        char *inner = wf_arena_print(a, "%.*s", (int)n - 1, text);
        own = inner ? note(t, inner, level, a) : NULL;
        return own ? wf_arena_print(a, "%s。", own) : NULL;
    }
    for (; level < sizeof clauses / sizeof *clauses; level++) {
        for (const char *at = text; (at = strstr(at, clauses[level].english)); at++) {
            char *first = wf_arena_print(a, "%.*s", (int)(at - text), text);
            const char *one = first ? note(t, first, level + 1, a) : NULL;
            const char *rest = one ? note(t, at + strlen(clauses[level].english), level, a) : NULL;
            if (rest) return wf_arena_print(a, "%s%s%s", one, clauses[level].own, rest);
        }
    }
    return NULL;
}

/* What a list is separated by, outermost first, and by what in Chinese. */
static const struct separator {
    const char *english, *own;
} separators[] = { { "; ", "；" }, { ": ", "：" }, { ", ", "、" } };

static const char *joined(const char *before, const char *mark, const char *after, struct wf_arena *a)
{
    return before && after ? wf_arena_print(a, "%s%s%s", before, mark, after) : NULL;
}

/* "frontal_share, streamlining.exponent": values of a crown, whose keys the strings have with "crown." before
 * them. */
static const char *of_crown(const struct wf_tongue *t, const char *text, struct wf_arena *a)
{
    const char *at = strstr(text, ", ");
    char *key = wf_arena_print(a, "crown.%.*s", at ? (int)(at - text) : (int)strlen(text), text);
    const char *one = key ? found(t, key) : NULL;
    if (!one) return NULL;
    const char *rest = at ? of_crown(t, at + 2, a) : NULL;
    return !at ? one : rest ? wf_arena_print(a, t->english ? "%s, %s" : "%s、%s", one, rest) : NULL;
}

/* Has a text three words in a row, or is it the last of "this, that, or those"? Then it is a part of a
 * sentence, of which no half is translated. */
static bool is_sentence(const char *text)
{
    size_t words = 0, letters = 0;
    if (!strncmp(text, "or ", 3) || !strncmp(text, "and ", 4)) return true;
    for (const char *p = text;; p++) {
        if (isalpha((unsigned char)*p)) {
            letters++;
            continue;
        }
        words = letters > 1 && (*p == ' ' || !*p) ? words + 1 : 0;
        if (words == 3) return true;
        if (!*p) return false;
        letters = 0;
    }
}

/* A list, each part by itself; `text` where no part has a translation. */
static const char *list(const struct wf_tongue *t, const char *text, struct wf_arena *a)
{
    for (size_t k = 0; k < sizeof separators / sizeof *separators; k++) {
        const char *at = strstr(text, separators[k].english);
        if (!at) continue;
        char *first = wf_arena_print(a, "%.*s", (int)(at - text), text);
        const char *rest = at + strlen(separators[k].english);
        const char *one = first ? piece(t, first, a) : NULL;
        const char *other =
            one && !strcmp(first, "crown") && separators[k].english[0] == ':' ? of_crown(t, rest, a) : NULL;
        if (one && !other) other = piece(t, rest, a);
        if (!other || (one == first && other == rest)) return text;
        if ((one == first && is_sentence(first)) || (other == rest && is_sentence(rest))) return text;
        return joined(one, t->english ? separators[k].english : separators[k].own, other, a);
    }
    return text;
}

/* "modulus_of_rupture (assumed)": a part with something in brackets behind. */
static const char *bracketed(const struct wf_tongue *t, const char *text, struct wf_arena *a)
{
    size_t n = strlen(text);
    const char *at = strstr(text, " (");
    if (!at || text[n - 1] != ')') return text;
    char *first = wf_arena_print(a, "%.*s", (int)(at - text), text);
    char *second = wf_arena_print(a, "%.*s", (int)(n - 3 - (size_t)(at - text)), at + 2);
    if (!first || !second) return text;
    const char *one = piece(t, first, a), *other = piece(t, second, a);
    if (one == first && other == second) return text;
    return wf_arena_print(a, t->english ? "%s (%s)" : "%s（%s）", one, other);
}

/* The arguments of a text that was put together by a template: what stands between its pieces, each as short
 * as it can be. */
static bool taken_apart(const char *template, const char *text, struct wf_arena *a, struct wf_said *out)
{
    const char *at = text, *p = template;
    *out = (struct wf_said){ .message = template };
    for (;;) {
        size_t n = strcspn(p, "{");
        if (strncmp(at, p, n)) return false;
        at += n, p += n;
        if (!*p) return !*at;
        size_t k = strtoul(p + 1, NULL, 10);
        p += strcspn(p, "}");
        if (!*p || !k || k > WF_SAID_MOST || out->arg[k - 1]) return false;
        char *next = wf_arena_print(a, "%.*s", (int)strcspn(p + 1, "{"), p + 1);
        const char *end = !next ? NULL : *next ? strstr(at, next) : at + strlen(at);
        if (end && next && !p[1 + strlen(next)] &&
            strlen(at) >= strlen(next)) /* the last piece ends the text */
            end = *next ? at + strlen(at) - strlen(next) : end;
        if (!end || !(out->arg[k - 1] = wf_arena_print(a, "%.*s", (int)(end - at), at))) return false;
        if (k > out->n) out->n = k;
        at = end, p++;
    }
}

static const char *by_template(const struct wf_tongue *t, const char *text, struct wf_arena *a);

/* An argument of a template. What stands in quotes, and single words, are what is typed; a name begins with a
 * capital. */
static const char *inner(const struct wf_tongue *t, const char *template, size_t k, const char *arg,
                         struct wf_arena *a)
{
    char quoted[32];
    (void)snprintf(quoted, sizeof quoted, "'{%zu}'", k);
    bool words = strchr(arg, ' ') != NULL;
    if (strstr(template, quoted) || (!words && !isupper((unsigned char)*arg))) return arg;
    const char *own = found(t, arg);
    if (!own && words) own = note(t, arg, 0, a);
    if (!own && words) own = by_template(t, arg, a);
    return own ? own : arg;
}

/* "crown_base: " before a sentence: bytes of it; 0: there is none. */
static size_t key_bytes(const char *text)
{
    size_t n = 0;
    while (isalnum((unsigned char)text[n]) || (text[n] && strchr("_.-", text[n]))) n++;
    return n && !strncmp(text + n, ": ", 2) ? n + 2 : 0;
}

/* A text that was put together in English, as errors are: by the template that has most of its letters.
 * Returned: NULL where there is none. */
static const char *by_template(const struct wf_tongue *t, const char *text, struct wf_arena *a)
{
    const struct template *best = NULL;
    struct wf_said said, most = { 0 };
    if (!strchr(text, ' ')) return NULL;
    for (size_t k = 0; k < t->templates; k++) {
        const struct template *one = &t->template[k];
        if ((best && one->letters <= best->letters) || !taken_apart(one->english, text, a, &said)) continue;
        best = one, most = said;
    }
    for (size_t k = 0; best && k < most.n; k++)
        most.arg[k] = most.arg[k] ? inner(t, best->english, k + 1, most.arg[k], a) : "";
    if (best) return wf_said_put(a, best->own, most.arg, most.n);
    size_t key = key_bytes(text);
    const char *rest = key ? found(t, text + key) : NULL;
    if (key && !rest) rest = by_template(t, text + key, a);
    return rest ? wf_arena_print(a, "%.*s：%s", (int)key - 2, text, rest) : NULL;
}

/* An argument, or a part of one. Returned: its translation, else `text` itself. */
static const char *piece(const struct wf_tongue *t, const char *text, struct wf_arena *a)
{
    const char *own = found(t, text);
    if (own) return own;
    if (!*text || strlen(text) > 2000) return text;
    own = t->english ? NULL : note(t, text, 0, a);
    if (!own && !t->english) own = by_template(t, text, a);
    if (own) return own;
    own = list(t, text, a);
    if (own == text) own = bracketed(t, text, a);
    return own ? own : text;
}

/* How wide a text stands on a terminal: Chinese characters take two columns. */
static int columns(const char *text)
{
    int n = 0;
    for (const unsigned char *p = (const unsigned char *)text; *p; p++)
        if ((*p & 0xC0) != 0x80) n += *p >= 0xE3 ? 2 : 1;
    return n;
}

static const char *fill(const char *text, int width, struct wf_arena *a)
{
    int blanks = abs(width) - columns(text);
    if (blanks <= 0) return text;
    return width > 0 ? wf_arena_print(a, "%*s%s", blanks, "", text)
                     : wf_arena_print(a, "%s%*s", text, blanks, "");
}

/* The translation of a message; blanks and line ends around it are not part of the catalogue's text. */
static const char *sentence(const struct wf_tongue *t, const char *message, struct wf_arena *a)
{
    if (t->english || found(t, message)) return wf_tongue_text(t, message);
    if (!message[strcspn(message, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ")])
        return message; /* arguments alone */
    size_t n = strlen(message), before = strspn(message, " \n"), behind = 0;
    while (behind < n - before && strchr(" \n", message[n - 1 - behind])) behind++;
    char *inner = wf_arena_print(a, "%.*s", (int)(n - before - behind), message + before);
    const char *own = inner ? found(t, inner) : NULL;
    return own ? wf_arena_print(a, "%.*s%s%s", (int)before, message, own, message + n - behind) : NULL;
}

char *wf_tongue_say(const struct wf_tongue *t, const struct wf_said *said, struct wf_arena *a)
{
    const char *arg[WF_SAID_MOST], *own = said->message ? sentence(t, said->message, a) : NULL;
    if (!own) return NULL;
    for (size_t k = 0; k < said->n; k++)
        if (!(arg[k] = fill(piece(t, said->arg[k], a), said->width[k], a))) return NULL;
    return wf_said_put(a, own, arg, said->n);
}

static void names_of(struct wf_tongue *t, const xmlNode *n, const char *name, const char *own)
{
    const xmlNode *english = child(n, name), *chinese = child(n, own);
    char *text = english && chinese ? text_of(english, &t->arena) : NULL,
         *other = text ? text_of(chinese, &t->arena) : NULL;
    if (!other) return;
    if (n->parent && !xmlStrcmp(n->parent->name, BAD_CAST "report"))
        text[strcspn(text, ",")] = '\0'; /* "Oak, the model": the species alone */
    wf_tongue_name(t, text, other);
}

/* `text` of an element that has `message` and `args`. */
static void say_again(const struct wf_tongue *t, xmlNode *n)
{
    struct wf_arena a = { 0 };
    struct wf_said said = { .message = text_of(child(n, "message"), &a) };
    const xmlNode *args = child(n, "args");
    for (const xmlNode *k = args ? args->children : NULL; k && said.n < WF_SAID_MOST; k = k->next)
        if (k->type == XML_ELEMENT_NODE && !(said.arg[said.n++] = text_of(child(k, "text"), &a)))
            said.message = NULL;
    char *own = said.message ? wf_tongue_say(t, &said, &a) : NULL;
    xmlNode *text = (xmlNode *)child(n, "text");
    if (own && text) {
        xmlNodeSetContent(text, NULL);
        xmlNodeAddContent(text, BAD_CAST own);
    }
    wf_arena_free(&a);
}

static void find_names(struct wf_tongue *t, const xmlNode *n)
{
    names_of(t, n, "name", "name_zh");
    names_of(t, n, "species_name", "species_zh");
    for (const xmlNode *k = n->children; k; k = k->next)
        if (k->type == XML_ELEMENT_NODE) find_names(t, k);
}

static bool is_leaf(const xmlNode *n)
{
    return n->children && n->children->type == XML_TEXT_NODE && !n->children->next;
}

/* "Oak, One stem shape for comparing species": species and model. The species alone is a key; pages take its
 * other name. */
static const char *name_of(const struct wf_tongue *t, const char *text, struct wf_arena *a)
{
    const char *own = list(t, text, a);
    return own != text ? own : NULL;
}

/* Words of the user, which are nobody's sentences. */
static bool is_users(const xmlNode *n)
{
    static const char *const own[] = { "name",     "title",        "client",     "site_name", "tree_number",
                                       "assessor", "organisation", "disclaimer", "command",   "model_name" };
    for (size_t k = 0; k < sizeof own / sizeof *own; k++)
        if (!xmlStrcmp(n->name, BAD_CAST own[k])) return true;
    return false;
}

/* Texts of more than a word; single words are keys, which the stylesheets know. */
static void translate(const struct wf_tongue *t, xmlNode *n)
{
    if (child(n, "message")) say_again(t, n);
    for (xmlNode *k = n->children; k; k = k->next) {
        if (k->type != XML_ELEMENT_NODE) continue;
        struct wf_arena a = { 0 };
        const char *text = is_leaf(k) ? (const char *)k->children->content : NULL;
        const char *own = text && (strchr(text, ' ') || !xmlStrcmp(k->name, BAD_CAST "note")) &&
                                  !t->english && strlen(text) < 4000
                              ? note(t, text, 0, &a)
                              : NULL;
        if (text && !own && !t->english && !is_users(k) && strlen(text) < 4000)
            own = by_template(t, text, &a);
        if (text && !t->english && !xmlStrcmp(k->name, BAD_CAST "name") && child(n, "name_zh"))
            own = n->parent && !xmlStrcmp(n->parent->name, BAD_CAST "report") ? name_of(t, text, &a) : NULL;
        if (own) {
            xmlNodeSetContent(k, NULL);
            xmlNodeAddContent(k, BAD_CAST own);
        } else if (!is_leaf(k))
            translate(t, k);
        wf_arena_free(&a);
    }
}

void wf_tongue_translate(struct wf_tongue *t, xmlNode *results)
{
    find_names(t, results);
    translate(t, results);
}
