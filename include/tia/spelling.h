/* spelling.h - words with two spellings, and the distance between two words: for readers of scene files and of options.
 *
 * tia writes the British spelling; both are read.
 */
#ifndef TIA_SPELLING_H
#define TIA_SPELLING_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* All words with two spellings: X(American, British). */
#define TIA_SPELLINGS(X)                                                                                               \
    X("color", "colour")                                                                                               \
    X("center", "centre")                                                                                              \
    X("disk", "disc")

#define TIA_NEAR 2         /* largest distance of a word that may have been meant */
#define TIA_NEAR_LENGTH 24 /* bytes; longer words are near none */

/* Returns the British spelling of a word of `length` bytes; NULL if the table has no such American word. */
static inline const char *tia_spelling_british(const char *word, size_t length)
{
#define TIA_SPELLING_PAIR(american, british) {american, british},
    static const char *const pairs[][2] = {TIA_SPELLINGS(TIA_SPELLING_PAIR)};
#undef TIA_SPELLING_PAIR

    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
        size_t same = 0;
        while (same < length && pairs[i][0][same] == word[same])
            same++; /* ends at the 0 of the shorter American word */
        if (same == length && !pairs[i][0][same])
            return pairs[i][1];
    }
    return NULL;
}

/* Fills the row of the distances between the first `i` bytes of `a` and the first 0..n of `b`, from the two rows before
 * it. */
static inline void tia_spelling_row(const char *a, size_t i, const char *b, size_t n,
                                    uint8_t row[3][TIA_NEAR_LENGTH + 1])
{
    uint8_t *now = row[i % 3];
    const uint8_t *last = row[(i + 2) % 3], *before = row[(i + 1) % 3];

    now[0] = (uint8_t)i;
    for (size_t j = 1; j <= n; j++) {
        unsigned d = last[j - 1] + (a[i - 1] != b[j - 1] ? 1u : 0u), gap = last[j] < now[j - 1] ? last[j] : now[j - 1];
        d = gap + 1u < d ? gap + 1u : d;
        if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] && before[j - 2] + 1u < d)
            d = before[j - 2] + 1u;
        now[j] = (uint8_t)d;
    }
}

/* Returns the distance of two words, of `m` and `n` bytes: the least number of bytes that must be inserted, deleted,
 * replaced or exchanged with their neighbours, no byte twice (optimal string alignment). Returns UINT32_MAX if `b`
 * cannot have been meant by `a`: above TIA_NEAR, or at half of its length or more, where nothing of it is left. */
static inline uint32_t tia_spelling_distance(const char *a, size_t m, const char *b, size_t n)
{
    uint8_t row[3][TIA_NEAR_LENGTH + 1];

    if (m > TIA_NEAR_LENGTH || n > TIA_NEAR_LENGTH || m > n + TIA_NEAR || n > m + TIA_NEAR)
        return UINT32_MAX;
    for (size_t j = 0; j <= n; j++)
        row[0][j] = (uint8_t)j;
    for (size_t i = 1; i <= m; i++)
        tia_spelling_row(a, i, b, n, row);
    uint32_t distance = row[m % 3][n];
    return distance > TIA_NEAR || 2 * distance >= n ? UINT32_MAX : distance;
}

#ifdef __cplusplus
}
#endif

#endif
