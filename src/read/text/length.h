/* length.h - lengths and positions in a unit that the reader chooses, so that small scenes use the range of Q16.16, and
 * large ones fit.
 *
 * A reader's first pass reads lengths in the file's unit, measures the extent of the scene, and computes scale_bits;
 * the last pass reads the lengths again, in the scene's unit. No number is rounded more than once. If the file's unit
 * is too small for Q16.16, the first pass is repeated in a larger unit.
 */
#ifndef TIA_READ_TEXT_LENGTH_H
#define TIA_READ_TEXT_LENGTH_H

#include "text_lines.h"

struct tia_span {
    int64_t min[3], max[3]; /* Q47.16 */
};

struct tia_lengths {
    int scale_bits;       /* the unit: a length of the file times 2^scale_bits is stored */
    bool filling;         /* the last pass: lengths are not measured any more */
    bool rounded;         /* a length had to be rounded to Q16.16 */
    bool finest;          /* use the whole range, even if no length is rounded */
    int64_t longest;      /* largest absolute length read; values read are clamped to Q16.16 */
    struct tia_span all;  /* bounds of the scene, with its lights and eyes */
    struct tia_span eyes; /* bounds of the eye's possible positions */
};

/* Makes the span empty. */
void tia_span_begin(struct tia_span *span);
/* Extends a span to cover a ball. */
void tia_span_cover(struct tia_span *span, struct tia_vec3 centre, int64_t radius);
/* Extends a span to cover another one. */
void tia_span_join(struct tia_span *span, const struct tia_span *more);

/* Begins a pass: empties the spans, and sets the scale. If `reach` (Q16.16, in the file's unit) is not 0, positions up
 * to `reach` from 0 must fit as well, and the finest possible unit is chosen. */
void tia_lengths_begin(struct tia_lengths *lengths, int scale_bits, tia_q16 reach);

/* Sets *scale_bits to the finest unit, no finer than that of the pass, in which all lengths of the pass fit. Returns
 * true if it is coarser, so that another pass is needed. */
bool tia_lengths_widen(const struct tia_lengths *lengths, int *scale_bits);

/* Returns x 2^bits, saturated and rounded up; bits is at most 32. */
int64_t tia_length_times(int64_t x, int bits);

/* Extends the bounds of the scene to cover a ball. */
void tia_lengths_cover(struct tia_lengths *lengths, struct tia_vec3 centre, int64_t radius);
/* Extends both bounds to cover a position of the eye. */
void tia_lengths_cover_eye(struct tia_lengths *lengths, struct tia_vec3 eye);

/* Returns the largest scale_bits, within +-TIA_SCALE_BITS_MAX, with which all lengths fit and nothing is farther from
 * the eye than tia_scene_check allows. */
int tia_lengths_room(const struct tia_lengths *lengths);

/* Reads a length in the unit of t->lengths. Before the last pass, measures it. */
int tia_text_length(struct tia_text *t, tia_q16 *out);
/* Reads a position likewise. */
int tia_text_place(struct tia_text *t, struct tia_vec3 *out);

/* Returns such a vector for one of Q31.32. */
struct tia_vec3 tia_vector_of(const int64_t v[3]);

/* Reads a length. In the last pass, sets *digits to its further digits, see struct tia_fine; before it, to 0. */
int tia_text_fine_length(struct tia_text *t, tia_q16 *out, int16_t *digits);
/* Reads a position likewise. */
int tia_text_fine_place(struct tia_text *t, struct tia_vec3 *out, struct tia_fine_place *digits);

/* Reads a vector whose length does not matter. If Q16.16 does not hold it exactly, scales it by a power of 2, so that
 * its largest component has 30 bits. */
int tia_text_vector(struct tia_text *t, struct tia_vec3 *out);

#endif
