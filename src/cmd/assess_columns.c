/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/assess_columns.h"
#include "base/column.h"
#include "base/num.h"
#include "base/text.h"
#include "cmd/option.h"
#include "cmd/scenarios.h"
#include <ctype.h>
#include <math.h>
#include <string.h>

/* ---- Names ---- */

/* Names of a column beside the option's own, with blanks between: English, German, French, Chinese. */
static const struct known {
    const char *option, *names;
    bool stand; /* of a tree in a stand */
} known[] = {
    { "--card", "tree_name baumname nom_arbre 树名", false },
    { "--species",
      "tree_species species_name latin_name botanical_name scientific_name art baumart baumart_botanisch "
      "gattung_art essence espece nom_latin nom_scientifique 树种 树种名 树种名称 学名 拉丁名",
      false },
    { "--height",
      "tree_height height_tree total_height h ht hohe hoehe baumhohe baumhoehe gesamthohe gesamthoehe "
      "wuchshohe scheitelhohe hauteur hauteur_totale hauteur_arbre 树高 高度 株高 全高 高",
      false },
    { "--girth",
      "gbh cbh circumference trunk_girth trunk_circumference stem_girth stem_circumference "
      "girth_at_breast_height umfang stammumfang stu bhu brusthohenumfang umfang_in_brusthohe "
      "stammumfang_in_brusthohe circonference circonference_tronc circonference_a_hauteur_poitrine 胸围 干周 "
      "胸径围 树干周长",
      false },
    { "--dbh",
      "d130 d13 diameter trunk_diameter stem_diameter diameter_at_breast_height bhd "
      "brusthohendurchmesser stammdurchmesser durchmesser_in_brusthohe diametre diametre_tronc "
      "diametre_a_hauteur_poitrine dhp 胸径 胸高直径",
      false },
    { "--crown-width",
      "crown_diameter crown_spread canopy_width canopy_spread canopy_diameter kronenbreite "
      "kronendurchmesser krone_durchmesser kronendm krone_o kronen_o largeur_houppier diametre_houppier "
      "largeur_couronne diametre_couronne "
      "冠幅 树冠宽 树冠直径 冠径",
      false },
    { "--crown-depth", "crown_length canopy_depth kronenlange kronenlaenge longueur_houppier 冠长 冠深",
      false },
    { "--crown-base",
      "crown_base_height height_crown_base height_to_crown_base kronenansatz kronenansatzhohe "
      "kronenansatzhoehe kronenbasis base_houppier hauteur_base_houppier base_couronne 枝下高 冠基高",
      false },
    { "--crown-form", "crown_shape kronenform forme_houppier forme_couronne 冠形 树冠形状", false },
    { "--frontal-area",
      "crown_area_side segelflache segelflaeche kronenansicht surface_frontale 迎风面积 树冠迎风面积",
      false },
    { "--lean",
      "lean_angle inclination neigung neigungswinkel schragstand stammneigung inclinaison "
      "inclinaison_tronc 倾斜 倾角 倾斜角 倾斜角度",
      false },
    { "--lean-towards", "lean_direction direction_lean neigungsrichtung direction_inclinaison 倾斜方向 倾向",
      false },
    { "--soil", "soil_type boden bodenart bodentyp sol type_sol 土壤 土壤类型 土质", false },
    { "--rooting", "rooting_depth durchwurzelung wurzeltiefe enracinement 根系深度", false },
    { "--cavity", "hohlung hoehlung hohle hoehle faulhohle cavite 空洞 树洞", false },
    { "--bark", "bark_thickness rinde rindendicke rindenstarke ecorce epaisseur_ecorce 树皮 树皮厚度 树皮厚",
      false },
    { "--season", "leaf_state belaubung saison 季节 叶态", false },
    { "--terrain",
      "terrain_category gelande gelaende gelandekategorie categorie_terrain 地面类别 地面粗糙度类别", false },
    { "--pull-moment", "zugversuch moment_traction 拉力试验 拉力试验弯矩", false },
    { "--required-safety", "sollsicherheit securite_requise 要求安全系数", false },
    { "--life", "", false },
    { "--snow", "snow_depth schnee schneehohe schneehoehe neige hauteur_neige 积雪 雪深 积雪深度", false },
    { "--ice", "ice_thickness eis eisdicke eisansatz glace givre 覆冰 冰厚 覆冰厚度", false },
    { "--root-stiffness", "wurzelsteifigkeit rigidite_racines 根系刚度 根部刚度", false },
    { "--spacing", "tree_spacing baumabstand pflanzabstand espacement ecartement 株距 株行距 树木间距",
      true },
    { "--stand-height", "top_height oberhohe oberhoehe bestandeshohe hauteur_dominante 优势高 林分高", true },
    { "--edge-distance", "distance_to_edge randabstand distance_lisiere 林缘距离", true },
    { "--gap", "gap_length lucke luecke trouee 林窗", true },
    { "--scans",
      "scan scan_file tree_file qsm qsm_file tree_model model_file scandatei baumdatei baummodell "
      "fichier_scan fichier_arbre modele_arbre 扫描 扫描文件 树模型 模型文件",
      false },
};

/* Heads that may be one of several options, or none of them, with or without a unit of the option's. */
static const struct ambiguous {
    const char *option, *names, *format;
} ambiguous[] = {
    { "--spacing", "abstand distance distanz entfernung ecart 距离 间距",
      "%s:%zu: error: column '%.60s' may be the spacing of a stand, the distance to its edge or "
      "neither; name it spacing or edge_distance, or by what it is, for example '%.60s road'" },
    { "--height",
      "crown_height height_crown canopy_height kronenhohe kronenhoehe hohe_krone hoehe_krone "
      "hauteur_houppier "
      "hauteur_couronne 冠高 树冠高 树冠高度 冠层高度",
      "%s:%zu: error: column '%.60s' may be the height of the crown's lower edge, of its top, or its depth; "
      "name it crown_base or crown_depth, or by what it is, for example '%.60s top'" },
    { "--azimuth", "azimuth azimut 方位角",
      "%s:%zu: error: column '%.60s' may be the direction of the wind, of a lean or of the tree from a "
      "point; "
      "name it lean_towards, or by what it is, for example '%.60s from plot'; winds from one direction alone "
      "are --azimuth, for all rows" },
};

/* Heads of lists of trees that are also options whose plain numbers mean something else there: a share of
 * leaves, the rain of a year, a kind of bark. They are read with a unit. */
static const char with_unit[] = "crown_density rain roughness";

/* Columns that say which tree a row is. */
static const char numbers[] =
    "number tree_number tree_no no nr n° id tree_id baum_id baumnummer baumnr numero "
    "numero_arbre num no_arbre 编号 树号 树木编号 序号";

/* Heads of lists of trees that are also options: they may name any place. */
static const char everyday[] = "site region";

/* Options of a run, or of a card, which no row has, and which change what is computed. */
static bool is_refused(const struct wf_option *row)
{
    static const char list[] =
        "scenarios samples seed mesh_tolerance north directions corridor "
        "corridor_towards tip_angle_limit search_to search_time climate dem at extremes";
    return row->kind == WF_OPTION_PATH || wf_scenario_changes(row) || wf_text_among(list, row->name + 2);
}

/* ---- Heads as they are compared ---- */

/* Letters of full width as ASCII, line ends as blanks. */
static char *widened(const char *head, struct wf_arena *a)
{
    char *text = wf_arena_text(a, head), *to = text;
    for (const unsigned char *p = (const unsigned char *)head; text && *p;) {
        bool wide = p[0] == 0xEF && (p[1] == 0xBC || p[1] == 0xBD) && p[2] >= 0x80;
        bool square = p[0] == 0xE3 && p[1] == 0x80 && (p[2] == 0x90 || p[2] == 0x91);
        bool blank = p[0] == 0xE3 && p[1] == 0x80 && p[2] == 0x80;
        if (wide && (p[1] == 0xBC ? p[2] > 0x80 : p[2] < 0x9F))
            *to++ = (char)(p[1] == 0xBC ? 0x21 + p[2] - 0x81 : 0x60 + p[2] - 0x80), p += 3;
        else if (square || blank)
            *to++ = blank ? ' ' : p[2] == 0x90 ? '[' : ']', p += 3;
        else
            *to++ = *p < ' ' ? ' ' : (char)*p, p++;
    }
    if (text) *to = '\0';
    return text;
}

/* Bytes at `p` of a height of 1.3 m; 0: none. */
static size_t breast_height(const char *p)
{
    static const char *const at[] = { "1.30", "1,30", "1.3", "1,3", "130" };
    for (size_t k = 0; k < WF_COUNT(at); k++) {
        size_t n = strlen(at[k]);
        if (strncmp(p, at[k], n)) continue;
        n += strspn(p + n, " ");
        const char *unit = *at[k] == '1' && at[k][1] == '3' ? "cm" : "m";
        if (!strncmp(p + n, unit, strlen(unit)) && !isalnum((unsigned char)p[n + strlen(unit)]))
            return n + strlen(unit);
    }
    return 0;
}

/* "Girth at 1.3 m (cm)" is "Girth (cm)": where girth and diameter are of the card. */
static void drop_breast_height(char *head)
{
    static const char *const before[] = { " at", " in", " @", " a", " \xC3\xA0", " auf", " bei", " en" };
    static const char *const behind[] = { " height", " H\xC3\xB6he", " de hauteur", " hauteur",
                                          " above ground" };
    for (char *p = head; *p; p++) {
        size_t n = p > head && (isdigit((unsigned char)p[-1]) || strchr(".,", p[-1])) ? 0 : breast_height(p);
        if (!n) continue;
        for (size_t k = 0; k < WF_COUNT(behind); k++)
            if (!strncmp(p + n, behind[k], strlen(behind[k]))) n += strlen(behind[k]);
        char *from = p;
        while (from > head && from[-1] == ' ') from--;
        for (size_t k = 0; k < WF_COUNT(before); k++) {
            size_t m = strlen(before[k]);
            if ((size_t)(from - head) >= m && !strncmp(from - m, before[k], m)) from -= m;
        }
        memmove(from, p + n, strlen(p + n) + 1);
        return;
    }
}

static bool is_particle(const char *word)
{
    static const char list[] = "of the de la le du des l d der die das den";
    return wf_text_among(list, word);
}

/* A name as it is compared: folded, without blanks, marks and particles: "hauteur de l'arbre" is
 * hauteurarbre. NULL: no memory. */
static const char *plain(const char *name, struct wf_arena *a)
{
    char *folded = NULL;
    const char *once = wf_text_folded(name, a);
    if (once) folded = wf_arena_text(a, once);
    char *to = folded, *rest = folded;
    for (char *word; to && (word = strtok_r(rest, " .,;:/'\"()[]", &rest));) {
        if (is_particle(word)) continue;
        size_t n = strlen(word);
        memmove(to, word, n), to += n;
    }
    if (to) *to = '\0';
    return folded;
}

/* Go through a list of names: each without '_'. Returned: false at the end. */
static bool next_name(const char **names, char *out, size_t size)
{
    size_t n = 0;
    *names += strspn(*names, " ");
    for (; **names && **names != ' '; ++*names)
        if (**names != '_' && **names != '-' && n + 1 < size) out[n++] = **names;
    out[n] = '\0';
    return n > 0;
}

static bool among(const char *names, const char *key)
{
    char one[120];
    while (next_name(&names, one, sizeof one))
        if (!strcmp(one, key)) return true;
    return false;
}

static bool is_called(const struct known *k, const char *key)
{
    return *key && (among(k->option + 2, key) || among(k->names, key));
}

/* ---- Units ---- */

/* Units in words, as they fold. */
static const struct unit_word {
    enum wf_dimension dimension;
    const char *symbol, *words;
} unit_words[] = {
    { WF_DIM_LENGTH, "cm",
      "cm centimetres centimeters centimetre centimeter zentimetern zentimeter 厘米 公分" },
    { WF_DIM_LENGTH, "mm", "mm millimetres millimeters millimetre millimeter millimetern 毫米" },
    { WF_DIM_LENGTH, "m", "m metres meters metre meter metern 米 公尺" },
    { WF_DIM_LENGTH, "inch", "inches inch zoll pouces pouce \" 英寸" },
    { WF_DIM_LENGTH, "foot", "feet foot ft fuss pieds pied ' 英尺" },
    { WF_DIM_AREA, "m2", "m2 qm sqm m² 平方米" },
    { WF_DIM_ANGLE, "degree", "degrees degree deg grad degres degre ° 度" },
};

/* A unit in words as its symbol; NULL: it is none of the dimension. */
static const char *symbol_of(const char *folded, enum wf_dimension d)
{
    char one[40];
    for (size_t k = 0; k < WF_COUNT(unit_words); k++)
        for (const char *names = unit_words[k].words;
             unit_words[k].dimension == d && next_name(&names, one, sizeof one);)
            if (!strcmp(one, folded)) return unit_words[k].symbol;
    return NULL;
}

/* Take off what leads to a unit: "Stammumfang in ", "circonference, en ". */
static void drop_lead(char *folded)
{
    static const char *const lead[] = { " in", " en", " unit", " einheit", " unite", "单位" };
    for (bool more = true; more;) {
        size_t n = strlen(folded);
        more = false;
        while (n && strchr(" ,:;/.", folded[n - 1])) folded[--n] = '\0';
        for (size_t k = 0; k < WF_COUNT(lead) && !more; k++) {
            size_t m = strlen(lead[k]);
            more = n > m && !strcmp(folded + n - m, lead[k]);
            if (more) folded[n - m] = '\0';
        }
    }
}

/* A head without its unit. */
struct apart {
    const char *stem; /* NULL: it has no unit of the dimension */
    double factor;
};

static bool factor_of(struct wf_units *u, const char *symbol, enum wf_dimension d, double *out)
{
    char text[100];
    struct wf_err unsaid = { WF_OK, "" };
    (void)snprintf(text, sizeof text, "1 %.80s", symbol);
    return *symbol && strlen(symbol) <= 60 && !wf_quantity_read(u, text, d, out, &unsaid);
}

/* The unit in the first brackets that have one: "(in cm)", "[cm] at the base", "(Zentimeter)". */
static struct apart in_brackets(struct wf_units *u, const char *head, enum wf_dimension d, struct wf_arena *a)
{
    struct apart out = { NULL, NAN };
    for (const char *open = strpbrk(head, "(["); open; open = strpbrk(open + 1, "([")) {
        const char *close = strchr(open, *open == '(' ? ')' : ']');
        if (!close) return out;
        char *inner = wf_arena_print(a, "%.*s", (int)(close - open - 1), open + 1);
        const char *text = inner ? wf_text_trim(inner) : "";
        static const char *const lead[] = { "in ", "en ", "单位", "unit", "Einheit" };
        for (size_t k = 0; k < WF_COUNT(lead); k++)
            if (!strncmp(text, lead[k], strlen(lead[k]))) text += strlen(lead[k]);
        text += strspn(text, " :");
        const char *folded = wf_text_folded(text, a), *symbol = folded ? symbol_of(folded, d) : NULL;
        if (!factor_of(u, symbol ? symbol : text, d, &out.factor)) continue;
        out.stem = wf_arena_print(a, "%.*s %s", (int)(open - head), head, close + 1);
        return out;
    }
    return out;
}

/* A unit in words at the end: "Stammumfang in cm", "GIRTH_CM", "胸围厘米". Of several the longest is taken.
 */
static struct apart at_end(struct wf_units *u, const char *head, enum wf_dimension d, struct wf_arena *a)
{
    struct apart out = { NULL, NAN };
    char one[40];
    size_t longest = 0;
    const char *folded = wf_text_folded(head, a), *symbol = NULL;
    size_t n = folded ? strlen(folded) : 0;
    for (size_t k = 0; k < WF_COUNT(unit_words); k++)
        for (const char *names = unit_words[k].words;
             unit_words[k].dimension == d && next_name(&names, one, sizeof one);) {
            size_t m = strlen(one);
            if (m <= longest || m >= n || strcmp(folded + n - m, one)) continue;
            bool apart = !isalnum((unsigned char)folded[n - m - 1]) || !isalpha((unsigned char)*one);
            if (apart) longest = m, symbol = unit_words[k].symbol;
        }
    char *stem = symbol ? wf_arena_print(a, "%.*s", (int)(n - longest), folded) : NULL;
    if (!stem || !factor_of(u, symbol, d, &out.factor)) return out;
    drop_lead(stem);
    out.stem = stem;
    return out;
}

static struct apart unit_apart(struct wf_units *u, const char *head, enum wf_dimension d, struct wf_arena *a)
{
    struct wf_err unsaid = { WF_OK, "" };
    struct apart out = in_brackets(u, head, d, a);
    size_t stem;
    if (out.stem) return out;
    if (wf_name_unit(u, head, d, &out.factor, &stem, &unsaid)) {
        char *text = wf_arena_print(a, "%.*s", (int)stem, head);
        const char *folded = text ? wf_text_folded(text, a) : NULL;
        char *less = folded ? wf_arena_text(a, folded) : NULL;
        if (less) drop_lead(less);
        out.stem = less;
        return out;
    }
    return at_end(u, head, d, a);
}

/* ---- Recognising ---- */

size_t wf_head_option(const struct wf_option *rows, const char *name)
{
    for (size_t k = 0; rows[k].name; k++)
        if (!strcmp(rows[k].name, name)) return k;
    return WF_HEAD_NONE;
}

/* One head: as it is compared, and for each dimension, when it is asked, without its unit. */
struct looked {
    struct wf_units *units;
    struct wf_arena *a;
    const char *head, *key;
    bool asked[WF_DIM_COUNT];
    struct apart apart[WF_DIM_COUNT];
    const char *less[WF_DIM_COUNT]; /* the same compared */
};

/* Is the head called so, with or without a unit of the dimension? Returned: *factor. */
static bool is_head(struct looked *l, const struct known *k, const struct wf_option *row, double *factor)
{
    enum wf_dimension d = row->dimension;
    bool numeric =
        row->kind == WF_OPTION_NUMBER || row->kind == WF_OPTION_SPEED || row->kind == WF_OPTION_SPEEDS;
    *factor = NAN;
    if (!numeric || d == WF_DIM_NONE) return is_called(k, l->key);
    if (!l->asked[d]) {
        l->asked[d] = true;
        l->apart[d] = unit_apart(l->units, l->head, d, l->a);
        l->less[d] = l->apart[d].stem ? plain(l->apart[d].stem, l->a) : NULL;
    }
    if (!l->less[d] || !is_called(k, l->less[d])) return is_called(k, l->key);
    *factor = l->apart[d].factor;
    return true;
}

/* Does the head begin with one of the names, or hold it, or is it the end of one? A short one says little. */
static bool is_near(const struct known *k, const char *key)
{
    enum { LEAST = 5 };
    char one[120];
    const char *lists[] = { k->option + 2, k->names };
    size_t n = strlen(key);
    for (size_t i = 0; i < WF_COUNT(lists); i++)
        while (next_name(&lists[i], one, sizeof one)) {
            size_t m = strlen(one);
            if (m >= LEAST ? strstr(key, one) != NULL : m == LEAST - 1 && !strncmp(key, one, m)) return true;
            if (n >= LEAST && m > n && !strcmp(one + m - n, key)) return true;
        }
    return false;
}

/* Is the head, with or without what may be a unit at its end, a name with a letter or two wrong? */
static bool is_misspelt(const struct looked *l, const struct known *k)
{
    enum { LEAST = 4, LONG = 6 };
    char one[120];
    const char *lists[] = { k->option + 2, k->names };
    for (size_t i = 0; i < WF_COUNT(lists); i++)
        while (next_name(&lists[i], one, sizeof one)) {
            const size_t n = strlen(one), most = n >= LONG ? 2 : 1;
            if (n < LEAST || one[0] != l->key[0]) continue; /* it is seldom the first letter */
            if (wf_word_distance(l->key, one) <= most) return true;
            for (size_t d = 0; d < WF_DIM_COUNT; d++)
                if (l->less[d] && wf_word_distance(l->less[d], one) <= most) return true;
        }
    return false;
}

/* An option whose own name the head nearly is; WF_HEAD_NONE: none. */
static size_t misspelt_option(const struct looked *l, const struct wf_option *rows)
{
    for (size_t k = 0; rows[k].name; k++) {
        const struct known own = { rows[k].name, "", false };
        if ((is_refused(&rows[k]) || wf_scenario_takes(&rows[k])) && is_misspelt(l, &own)) return k;
    }
    return WF_HEAD_NONE;
}

/* An option by its own name, which has no others. */
static bool by_own_name(struct looked *l, const struct wf_assess_options *line, struct wf_head *out)
{
    const struct wf_option *rows = line->run.args.option;
    const char *code = line->run.profile.design.code;
    for (size_t k = 0; rows[k].name; k++) {
        const struct known own = { rows[k].name, "", false };
        bool refused = is_refused(&rows[k]);
        if ((!refused && !wf_scenario_takes(&rows[k])) || !is_head(l, &own, &rows[k], &out->factor)) continue;
        out->option = k;
        out->use = refused ? WF_HEAD_REFUSED : WF_HEAD_READ;
        out->own = !refused;
        bool place = among(everyday, l->key), words = rows[k].kind == WF_OPTION_CHOICE;
        if (place && words) out->use = WF_HEAD_WORDS;
        if (place && !words && !(code && !strcmp(code, "asnzs1170"))) out->use = WF_HEAD_KEPT;
        if (among(with_unit, l->key)) out->use = WF_HEAD_NEAR;
        return true;
    }
    return false;
}

static void recognise(struct looked *l, const struct wf_assess_options *line, struct wf_head *out)
{
    const struct wf_option *rows = line->run.args.option;
    const bool rooting = line->run.anchorage.table != NULL;
    *out = (struct wf_head){ .use = WF_HEAD_KEPT, .option = WF_HEAD_NONE, .factor = NAN };
    for (size_t k = 0; k < WF_COUNT(known); k++) {
        size_t row = wf_head_option(rows, known[k].option);
        if (!is_head(l, &known[k], &rows[row], &out->factor)) continue;
        /* of a table of anchorage alone: without one it changes nothing */
        if (!rooting && !strcmp(known[k].option, "--rooting")) return;
        out->use = WF_HEAD_READ, out->option = row, out->stand = known[k].stand;
        return;
    }
    if (by_own_name(l, line, out)) return;
    out->factor = NAN;
    for (size_t k = 0; k < WF_COUNT(known) && out->use == WF_HEAD_KEPT; k++)
        if ((is_near(&known[k], l->key) || is_misspelt(l, &known[k])) &&
            (rooting || strcmp(known[k].option, "--rooting")))
            out->use = WF_HEAD_NEAR, out->option = wf_head_option(rows, known[k].option);
    if (out->use == WF_HEAD_KEPT && (out->option = misspelt_option(l, rows)) != WF_HEAD_NONE)
        out->use = WF_HEAD_NEAR;
}

/* Fail where the head may be several options. */
static enum wf_status check_ambiguous(const struct wf_heads *h, size_t i, struct looked *l, struct wf_err *e)
{
    const struct wf_rows *r = h->rows;
    double factor;
    for (size_t k = 0; k < WF_COUNT(ambiguous); k++) {
        const struct known names = { "--", ambiguous[k].names, false };
        if (is_head(l, &names, &h->option[wf_head_option(h->option, ambiguous[k].option)], &factor))
            return wf_fail(e, WF_EINPUT, ambiguous[k].format, r->file, r->line, r->name[i], r->name[i]);
    }
    return WF_OK;
}

static enum wf_status check_head(const struct wf_heads *h, size_t i, struct wf_err *e)
{
    const struct wf_rows *r = h->rows;
    if (!strncmp(r->name[i], "wf_", 3))
        return wf_fail(
            e, WF_EINPUT,
            "%s:%zu: error: column '%.60s' has a name that this command adds; take out the columns of an "
            "earlier assessment",
            r->file, r->line, r->name[i]);
    for (size_t j = 0; j < i; j++)
        if (h->head[i].use >= WF_HEAD_READ && h->head[j].use >= WF_HEAD_READ &&
            h->head[i].option == h->head[j].option)
            return wf_fail(e, WF_EINPUT,
                           "%s:%zu: error: columns '%.60s' and '%.60s' are both taken as %s; rename one",
                           r->file, r->line, r->name[j], r->name[i], h->option[h->head[i].option].name);
    return WF_OK;
}

/* Near names of options that another column has are no news. */
static void drop_known_near(struct wf_heads *h)
{
    for (size_t i = 0; i < h->rows->columns; i++)
        for (size_t j = 0; j < h->rows->columns && h->head[i].use == WF_HEAD_NEAR; j++)
            if (h->head[j].use >= WF_HEAD_READ && h->head[j].option == h->head[i].option)
                h->head[i].use = WF_HEAD_KEPT;
}

enum wf_status wf_heads_read(const struct wf_rows *r, const struct wf_assess_options *line,
                             struct wf_units *units, struct wf_arena *a, struct wf_heads *out,
                             struct wf_err *e)
{
    const struct wf_option *rows = line->run.args.option;
    *out = (struct wf_heads){ .rows = r, .option = rows, .scan = WF_HEAD_NONE, .spacing = WF_HEAD_NONE };
    out->head = WF_TAKE(a, r->columns, struct wf_head);
    enum wf_status s = WF_OK;
    for (size_t k = 0; out->head && k < r->columns && !s; k++) {
        char *head = widened(r->name[k], a);
        if (head) drop_breast_height(head);
        struct looked l = { .units = units, .a = a, .head = head, .key = head ? plain(head, a) : NULL };
        if (!l.key) return wf_fail(e, WF_ENOMEM, "not enough memory for a table");
        recognise(&l, line, &out->head[k]);
        out->head[k].number = among(numbers, l.key);
        s = check_ambiguous(out, k, &l, e);
        if (!s) s = check_head(out, k, e);
        const char *name = out->head[k].use == WF_HEAD_READ ? rows[out->head[k].option].name : "";
        if (!strcmp(name, "--scans")) out->scan = k;
        if (!strcmp(name, "--spacing")) out->spacing = k;
    }
    if (!out->head) return wf_fail(e, WF_ENOMEM, "not enough memory for a table");
    drop_known_near(out);
    return s;
}

/* ---- What is missing ---- */

static bool is_there(const struct wf_heads *h, const struct wf_args *line, const char *option)
{
    size_t row = wf_head_option(h->option, option);
    bool there = line->given[row];
    for (size_t k = 0; k < h->rows->columns; k++)
        there = there || (h->head[k].use == WF_HEAD_READ && h->head[k].option == row);
    return there;
}

/* Neither a wind, nor what an option of the command line acts beside. */
static enum wf_status check_beside(const struct wf_heads *h, const struct wf_args *line, struct wf_err *e)
{
    if (!is_there(h, line, "--wind") && !is_there(h, line, "--design"))
        return wf_fail(
            e, WF_EINPUT,
            "%s:%zu: error: no column, and no option, gives the wind: --wind 25 or --design en1991 "
            "--basic-wind 25 for all rows, or a column wind_m_s, or columns design and basic_wind",
            h->rows->file, h->rows->line);
    for (const struct wf_assess_beside *b = wf_assess_besides; b->option; b++) {
        bool acts = !line->given[wf_head_option(h->option, b->option)];
        for (size_t k = 0; k < WF_COUNT(b->other) && b->other[k]; k++)
            acts = acts || is_there(h, line, b->other[k]);
        if (!acts)
            return wf_fail(e, WF_EUSAGE, "%s: has no effect %s, and no column is that", b->option,
                           b->without);
    }
    return WF_OK;
}

enum wf_status wf_heads_check(const struct wf_heads *h, const struct wf_args *line, struct wf_err *e)
{
    static const char *const needed[][3] = { { "--species" },
                                             { "--height" },
                                             { "--girth", "--dbh" },
                                             { "--crown-width", "--frontal-area", "--photo-outline" },
                                             { "--crown-base", "--crown-depth", "--photo-outline" } };
    char missing[200] = "";
    bool any = false;
    for (size_t k = 0; k < h->rows->columns; k++) any = any || h->head[k].use == WF_HEAD_READ;
    if (!any)
        return wf_fail(e, WF_EINPUT,
                       "%s:%zu: error: no column is recognised in the header, which begins with '%.60s'. The "
                       "first line that is "
                       "neither blank nor a remark (#) names the columns, for example "
                       "species,height_m,girth_cm,crown_width_m,crown_base_m",
                       h->rows->file, h->rows->line, h->rows->name[0]);
    for (size_t k = 0; k < WF_COUNT(needed) && h->scan == WF_HEAD_NONE; k++) {
        bool there = false;
        for (size_t i = 0; i < 3 && needed[k][i]; i++) there = there || is_there(h, line, needed[k][i]);
        size_t n = strlen(missing);
        if (!there) (void)snprintf(missing + n, sizeof missing - n, "%s%s", n ? ", " : "", needed[k][0] + 2);
    }
    if (!*missing) return check_beside(h, line, e);
    return wf_fail(e, WF_EINPUT,
                   "%s:%zu: error: no column, and no option, gives %s: no row could be assessed",
                   h->rows->file, h->rows->line, missing);
}

/* ---- What is said ---- */

/* "'height_m' (--height), ..." of the columns of a use; NULL: there is none. */
static const char *listed(const struct wf_heads *h, enum wf_head_use use, struct wf_arena *a)
{
    const char *text = NULL;
    for (size_t k = 0; k < h->rows->columns; k++) {
        if (h->head[k].use != use) continue;
        bool option = use != WF_HEAD_KEPT && k != h->scan;
        text = wf_arena_print(a, "%s%s'%.60s'%s%s%s", text ? text : "", text ? ", " : "", h->rows->name[k],
                              option ? " (" : "", option ? h->option[h->head[k].option].name : "",
                              option ? ")" : "");
    }
    return text;
}

void wf_heads_say(const struct wf_heads *h, struct wf_arena *a)
{
    const char *taken = listed(h, WF_HEAD_READ, a), *kept = listed(h, WF_HEAD_KEPT, a),
               *near = listed(h, WF_HEAD_NEAR, a), *words = listed(h, WF_HEAD_WORDS, a),
               *refused = listed(h, WF_HEAD_REFUSED, a);
    wf_show(stderr, "%s: columns taken: %s; only kept: %s\n", h->rows->file, taken ? taken : "none",
            kept ? kept : "none");
    if (near)
        wf_show(
            stderr,
            "%s: not read, though near to the name of an option: %s; if that is meant, name the column as "
            "the option, with its unit, for example 'height_m'\n",
            h->rows->file, near);
    if (words)
        wf_show(stderr, "%s: read only where a cell is a word of the option: %s\n", h->rows->file, words);
    if (refused)
        wf_show(stderr, "%s: not read from a table; rows with a value there are not assessed: %s\n",
                h->rows->file, refused);
}
