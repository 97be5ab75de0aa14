/* fields.h - what stands on a line of a .tia file: fields, each a word and its values, in any order.
 *
 *     radius 3 material glass at 0 1 0
 */
#ifndef TIA_SRC_READ_FIELDS_H
#define TIA_SRC_READ_FIELDS_H

#include "text.h"

enum tia_field_kind {
    TIA_NUMBERS,    /* `count` tia_q16, one after the other */
    TIA_SPREAD,     /* the same; one number stands for all */
    TIA_COLOUR,     /* a tia_rgb: three numbers, or one for a grey */
    TIA_DIRECTION,  /* a tia_dir3 of any length but 0; it gets 1 */
    TIA_WHOLE,      /* `count` uint16_t in 1..max */
    TIA_FLAG,       /* no value: a bool becomes true */
    TIA_NAME_FIELD, /* a thing's name, a tia_word */
    TIA_FILE_FIELD  /* a file's name, a tia_word */
};

struct tia_field {
    const char *word;
    uint8_t kind, count;
    uint16_t max;
    uint16_t offset; /* of what it fills */
    bool needed;     /* a line without it is no line */
};

/* Fills `out` from the rest of the line. Bit n of *given (which may be NULL): fields[n] was there.
 * `what` is for errors: "a sphere". */
int tia_fields(struct tia_text *t, const char *what, const struct tia_field *fields, unsigned count, void *out,
               uint32_t *given);

/* One field's values, or those of a keyframe. */
int tia_colour(struct tia_text *t, struct tia_rgb *out);
int tia_spread(struct tia_text *t, tia_q16 *out, unsigned count);

#define TIA_COUNT_OF(array) ((unsigned)(sizeof(array) / sizeof *(array)))

#endif
