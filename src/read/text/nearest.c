#include "nearest.h"

#define LONGEST 24 /* longer words are near none */

static unsigned least(unsigned a, unsigned b)
{
    return a < b ? a : b;
}

/* Fills the row of the distances between the first `i` letters of the word and the first 0..n of the candidate, from
 * the two rows before it. */
static void fill_row(const char *word, unsigned i, const char *candidate, unsigned n, uint8_t row[3][LONGEST + 1])
{
    uint8_t *now = row[i % 3], *last = row[(i + 2) % 3], *before = row[(i + 1) % 3];

    now[0] = (uint8_t)i;
    for (unsigned j = 1; j <= n; j++) {
        bool same = word[i - 1] == candidate[j - 1];
        unsigned d = least(least(last[j], now[j - 1]) + 1u, last[j - 1] + (same ? 0u : 1u));
        if (i > 1 && j > 1 && word[i - 1] == candidate[j - 2] && word[i - 2] == candidate[j - 1])
            d = least(d, before[j - 2] + 1u);
        now[j] = (uint8_t)d;
    }
}

void tia_nearest_try(struct tia_nearest *nearest, const char *candidate)
{
    const struct tia_word *word = nearest->word;
    uint8_t row[3][LONGEST + 1];
    unsigned n = 0;

    while (candidate[n])
        n++;
    if (n > LONGEST || word->length > LONGEST)
        return;
    for (unsigned j = 0; j <= n; j++)
        row[0][j] = (uint8_t)j;
    for (unsigned i = 1; i <= word->length; i++)
        fill_row(word->at, i, candidate, n, row);
    unsigned distance = row[word->length % 3][n];
    if (distance > TIA_NEAR || 2 * distance >= n || (nearest->candidate && distance >= nearest->distance))
        return;
    nearest->candidate = candidate;
    nearest->distance = distance;
}
