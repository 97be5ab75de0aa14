/* near_word.h - the option, or the word of one, that was probably meant. */
#ifndef TOOLS_COMMON_NEAR_WORD_H
#define TOOLS_COMMON_NEAR_WORD_H

#include <tia/spelling.h>

/* A word, and the nearest candidate, the first of those at the smallest distance; found NULL: none is near. */
struct near_word {
    const char *word;
    size_t length;
    const char *found;
    size_t found_length;
    uint32_t distance;
};

/* Compares the word with one more candidate. */
static inline void near_word_try(struct near_word *near, const char *candidate, size_t length)
{
    uint32_t distance = tia_spelling_distance(near->word, near->length, candidate, length);

    if (distance > TIA_NEAR || (near->found && distance >= near->distance))
        return;
    near->found = candidate;
    near->found_length = length;
    near->distance = distance;
}

#endif
