#include "base/near.h"
#include <stdbool.h>
#include <string.h>

enum { WORD_MAX = 63 };

static unsigned char lower(char c) { return (unsigned char)(c >= 'A' && c <= 'Z' ? c + ('a' - 'A') : c); }

static size_t least(size_t a, size_t b) { return a < b ? a : b; }

size_t wf_word_distance(const char *a, const char *b)
{
    size_t n = strlen(a), m = strlen(b);
    if (n > WORD_MAX || m > WORD_MAX) return (size_t)-1;
    size_t row[3][WORD_MAX + 1]; /* rows i-2, i-1, i of the table, in turn */
    for (size_t j = 0; j <= m; j++) row[0][j] = j;
    for (size_t i = 1; i <= n; i++) {
        size_t *now = row[i % 3], *before = row[(i + 2) % 3], *earlier = row[(i + 1) % 3];
        now[0] = i;
        for (size_t j = 1; j <= m; j++) {
            unsigned char x = lower(a[i - 1]), y = lower(b[j - 1]);
            now[j] = least(before[j - 1] + (x != y), least(before[j], now[j - 1]) + 1);
            if (i > 1 && j > 1 && x == lower(b[j - 2]) && lower(a[i - 2]) == y)
                now[j] = least(now[j], earlier[j - 2] + 1);
        }
    }
    return row[n % 3][m];
}

int wf_word_is_near(const char *word, size_t distance)
{
    size_t n = strlen(word);
    return distance <= (n <= 4 ? 1u : n <= 8 ? 2u : 3u);
}

/* One word begins with the other, as "youngs" for "youngs_modulus". */
static bool shortened(const char *a, const char *b)
{
    size_t n = 0;
    while (a[n] && b[n] && lower(a[n]) == lower(b[n])) n++;
    return n >= 3 && (!a[n] || !b[n]);
}

const char *wf_nearest(const char *word, const char *const *known, size_t n)
{
    const char *best = NULL;
    size_t best_distance = (size_t)-1;
    for (size_t i = 0; i < n; i++) {
        size_t d = wf_word_distance(word, known[i]);
        if (d < best_distance && wf_word_is_near(word, d)) {
            best = known[i];
            best_distance = d;
        }
    }
    for (size_t i = 0; i < n && !best; i++)
        if (shortened(word, known[i])) best = known[i];
    return best;
}
