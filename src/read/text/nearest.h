/* nearest.h - the word that was probably meant. */
#ifndef TIA_READ_TEXT_NEAREST_H
#define TIA_READ_TEXT_NEAREST_H

#include "text_lines.h"

#define TIA_NEAR 2 /* largest distance of a word that may have been meant */

/* A word, and the candidate nearest to it: the first of those at the smallest distance up to TIA_NEAR. NULL: none. */
struct tia_nearest {
    const struct tia_word *word;
    const char *candidate;
    unsigned distance;
};

/* Compares the word with one more candidate. The distance is the least number of letters that must be inserted,
 * deleted, replaced or exchanged with their neighbours, no letter twice (optimal string alignment). At a
 * distance of half of the candidate's length or more nothing of it is left. */
void tia_nearest_try(struct tia_nearest *nearest, const char *candidate);

#endif
