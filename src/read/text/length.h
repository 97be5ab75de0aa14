/* length.h - lengths and positions in a unit of their own, so that a scene of small numbers uses the range of Q16.16,
 * and one of large numbers fits.
 *
 * A reader's first pass reads them in the file's unit, covers all parts of the scene, and computes scale_bits; the last
 * pass reads them again with scale_bits set. No number is rounded more than once. Where the file's unit is too small
 * for Q16.16, the first pass is repeated in a larger one.
 */
#ifndef TIA_READ_TEXT_LENGTH_H
#define TIA_READ_TEXT_LENGTH_H

#include "text_lines.h"

struct tia_span {
    int64_t min[3], max[3]; /* Q47.16 */
};

struct tia_lengths {
    int scale_bits;       /* lengths are read times 2^scale_bits */
    bool filling;         /* the last pass: lengths are not measured any more */
    bool rounded;         /* a length was not exact in Q16.16 */
    bool finest;          /* use the whole range, even if no length is rounded */
    int64_t longest;      /* largest absolute length read; values read are clamped to Q16.16 */
    struct tia_span all;  /* span of the scene, with its lights and eyes */
    struct tia_span eyes; /* span of the positions that the eye may have */
};

/* Makes an empty span. */
void tia_span_begin(struct tia_span *span);
/* Adds a ball to a span. */
void tia_span_cover(struct tia_span *span, struct tia_vec3 centre, int64_t radius);
/* Adds another span. */
void tia_span_join(struct tia_span *span, const struct tia_span *more);

/* Begins a pass: nothing measured yet, and lengths are read times 2^scale_bits. If `reach` is not 0, positions as far
 * as `reach` from 0, Q16.16 of the file's unit, must fit as well, and the finest unit is wanted. */
void tia_lengths_begin(struct tia_lengths *lengths, int scale_bits, tia_q16 reach);

/* Gives in *scale_bits the unit in which all lengths of the pass fit; true if it is coarser: another pass is needed. */
bool tia_lengths_widen(const struct tia_lengths *lengths, int *scale_bits);

/* Returns x times 2^bits, bits at most 16, saturated; rounded up. */
int64_t tia_length_times(int64_t x, int bits);

/* Adds a ball to the span of the scene. */
void tia_lengths_cover(struct tia_lengths *lengths, struct tia_vec3 centre, int64_t radius);
/* Adds a position of the eye to both spans. */
void tia_lengths_cover_eye(struct tia_lengths *lengths, struct tia_vec3 eye);

/* Returns the largest scale_bits, up to TIA_SCALE_BITS_MAX in size, with which all lengths fit, and nothing is farther
 * from the eye than tia_scene_check allows. */
int tia_lengths_room(const struct tia_lengths *lengths);

/* Reads a length in the unit of t->lengths; measures it before the last pass. */
int tia_text_length(struct tia_text *t, tia_q16 *out);
/* Reads a position likewise. */
int tia_text_place(struct tia_text *t, struct tia_vec3 *out);

/* Reads a length with more digits, see struct tia_fine, in the last pass; *digits is 0 before it. */
int tia_text_fine_length(struct tia_text *t, tia_q16 *out, int16_t *digits);
/* Reads a position likewise. */
int tia_text_fine_place(struct tia_text *t, struct tia_vec3 *out, struct tia_fine_place *digits);

/* Reads a vector whose length does not matter: unchanged if Q16.16 holds it exactly, else scaled by a power of 2, so
 * that its largest component has 30 bits. */
int tia_text_vector(struct tia_text *t, struct tia_vec3 *out);

#endif
