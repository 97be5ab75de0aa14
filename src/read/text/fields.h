/* fields.h - the fields on a line of a .tia file, each a word and its values, in any order.
 *
 *     radius 3 material glass at 0 1 0
 */
#ifndef TIA_READ_TEXT_FIELDS_H
#define TIA_READ_TEXT_FIELDS_H

#include "text_lines.h"

enum tia_field_kind {
    TIA_NUMBERS,    /* `count` tia_q16 */
    TIA_LENGTHS,    /* `count` tia_q16 in the scene's unit of length, see length.h */
    TIA_VECTOR,     /* a tia_vec3 whose length does not matter */
    TIA_SPREAD,     /* `count` tia_q16; a single number sets all of them */
    TIA_LONGS,      /* `count` int64_t, Q31.32; if `max` is 1, a single number sets all of them */
    TIA_COLOUR,     /* a tia_rgb: three numbers in 0..1, or one for a grey */
    TIA_EMISSION,   /* a struct tia_emission: below 16384, or to 8192, see `max` */
    TIA_FADING,     /* a struct tia_fading: three numbers */
    TIA_DIRECTION,  /* a tia_dir3: any vector but 0, normalised */
    TIA_WHOLE,      /* `count` uint16_t in 1..max */
    TIA_FLAG,       /* no value; sets a bool to true */
    TIA_NAME_FIELD, /* a tia_word: the name of a material, texture, ... */
    TIA_FILE_FIELD  /* a tia_word: the name of a file */
};

struct tia_field {
    const char *word;
    uint8_t kind, count;
    uint16_t max;    /* TIA_WHOLE: largest value; TIA_EMISSION: 1 if `rgb` must be at most 1; TIA_LONGS: see there */
    uint16_t offset; /* byte offset in the struct that the fields fill */
    bool needed;     /* a line without the field is an error */
};

/* Fills `out` from the rest of the line. If `given` is not NULL, sets bit n of *given if the line has fields[n]. `what`
 * names the statement in errors: "a sphere". */
int tia_fields(struct tia_text *t, const char *what, const struct tia_field *fields, unsigned count, void *out,
               uint32_t *given);

/* The colour rgb times 2^bits. `bits` is as small as possible: each channel of rgb must be below 2 or, if the field's
 * `max` is 1, at most 1. */
struct tia_emission {
    struct tia_rgb rgb;
    uint8_t bits;
};

/* A light's attenuation, as in struct tia_light. The reader chooses the unit of length, 2^unit_bits units of the file,
 * so that `linear` and `quadratic` lose little precision in Q16.16. */
struct tia_fading {
    tia_q16 constant, linear, quadratic;
    int8_t unit_bits;
};

/* One of several forms of a statement. The word after the statement names the form: "camera frustum ...". */
struct tia_form {
    const char *word, *what; /* `what`: the name in errors, as for tia_fields */
    unsigned kind;           /* value for the caller */
    const struct tia_field *fields;
    unsigned count;
};

/* Sets *form to the form that the next word names, and skips the word. If the word is a field, sets *form to the first
 * one, and the word stays unread. Fails at a misspelt form. */
int tia_form(struct tia_text *t, const struct tia_form *forms, unsigned count, const struct tia_form **form);

/* Reads an emission; `most` is the upper limit of out->rgb's channels, Q2.30. */
int tia_emission(struct tia_text *t, struct tia_emission *out, tia_q30 most);
/* Reads the three numbers of an attenuation. */
int tia_fading(struct tia_text *t, struct tia_fading *out);
/* Reads a colour: three numbers in 0..1, or one for a grey. */
int tia_colour(struct tia_text *t, struct tia_rgb *out);
/* Reads `count` numbers, or a single number that sets all of them. */
int tia_spread(struct tia_text *t, tia_q16 *out, unsigned count);

#define TIA_COUNT_OF(array) ((unsigned)(sizeof(array) / sizeof *(array)))

#endif
