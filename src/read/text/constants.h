/* constants.h - names for numbers:  define RADIUS 2.5
 *
 * The table is small, since it is on the reader's stack: it is used in the first pass, too, which stores nothing in the
 * arena. A name begins with a capital letter, which no field does, so that a field after an optional number is not a
 * name. It stands for numbers only, never for other names, so that expansion cannot grow exponentially.
 */
#ifndef TIA_READ_TEXT_CONSTANTS_H
#define TIA_READ_TEXT_CONSTANTS_H

#include "text_lines.h"

#define TIA_CONSTANTS_MAX 128

struct tia_constant {
    const char *name, *end; /* the numbers follow the name, up to the end of its line; `end` is the text's end */
    uint32_t length;        /* length of the name */
};

struct tia_constants {
    uint32_t count;
    struct tia_constant at[TIA_CONSTANTS_MAX];
};

/* True if a name, not empty, can be a constant's: it begins with a capital letter. */
bool tia_constant_named(const char *name);
/* Finds a constant; NULL: none. */
const struct tia_constant *tia_constant_find(const struct tia_constants *constants, const char *name, uint32_t length);

/* Makes the numbers of the constant `word`, perhaps with a minus before it, the next words of the text; false: `word`
 * is not a constant. */
bool tia_constant_use(struct tia_text *t, const struct tia_word *word);

#endif
