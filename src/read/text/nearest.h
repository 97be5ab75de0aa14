/* nearest.h - the word that was probably meant. */
#ifndef TIA_READ_TEXT_NEAREST_H
#define TIA_READ_TEXT_NEAREST_H

#include "text_lines.h"
#include <tia/spelling.h>

#define TIA_LIST_MOST 8  /* most words of a list that an error message shows whole */
#define TIA_LIST_START 3 /* number of words that it shows of a longer one */

/* A word, and the candidate nearest to it: the first of those at the smallest distance up to TIA_NEAR; its length is 0
 * if there is none. */
struct tia_nearest {
    const struct tia_word *word;
    struct tia_word candidate;
    uint32_t distance;
};

/* Compares the word with one more candidate. */
void tia_nearest_try(struct tia_nearest *nearest, const char *candidate);
void tia_nearest_try_word(struct tia_nearest *nearest, const struct tia_word *candidate);

/* Sets the error "'WORD' WHAT, expected ..." with the nearest of the words of `list`, as "a, b or c", or else the list.
 * Returns TIA_ERR_RANGE. If `meant` is not NULL, it receives the
 * nearest word, or an empty one. */
int tia_text_error_of(struct tia_text *t, const struct tia_word *word, const char *what, const char *list,
                      struct tia_word *meant);

#endif
