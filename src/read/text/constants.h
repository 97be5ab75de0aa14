/* constants.h - names for numbers:  define RADIUS 2.5
 *
 * The table is small, since it is on the reader's stack: the first pass needs it, too, and stores nothing in the arena.
 * A name begins with a capital letter. No field does, so a field after an optional number is never taken for a name. A
 * name stands for numbers only, never for other names, so that expansion cannot grow exponentially.
 */
#ifndef TIA_READ_TEXT_CONSTANTS_H
#define TIA_READ_TEXT_CONSTANTS_H

#include "text_lines.h"

#define TIA_CONSTANTS_MAX 128

struct tia_constant {
    const char *name, *end; /* the name, followed by its numbers up to the end of its line; the text's end, or NULL if
                               the line has a mistake */
    uint32_t length;        /* length of the name */
};

struct tia_constants {
    uint32_t count;
    struct tia_constant at[TIA_CONSTANTS_MAX];
};

/* True if a name, not empty, may be that of a constant: it begins with a capital letter. */
bool tia_constant_named(const char *name);
/* Finds a constant; returns NULL if there is none of that name. */
const struct tia_constant *tia_constant_find(const struct tia_constants *constants, const char *name, uint32_t length);

/* If `word` is a constant, perhaps with a minus before it, makes its numbers the next words of the text. Otherwise
 * returns false. */
bool tia_constant_use(struct tia_text *t, const struct tia_word *word);

#endif
