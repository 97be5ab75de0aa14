/* surface.h - material values shared by the readers of NFF and OBJ. */
#ifndef TIA_READ_SURFACE_H
#define TIA_READ_SURFACE_H

#include "read/text/text_lines.h"

static inline struct tia_rgb tia_grey(tia_q30 x)
{
    return (struct tia_rgb){x, x, x};
}

/* Returns a b, clamped to the largest Q2.30; a and b are 0 or more. */
tia_q30 tia_q30_product(tia_q30 a, tia_q30 b);
/* Returns the colour with each channel multiplied by `by`, clamped to the largest Q2.30. */
struct tia_rgb tia_rgb_product(struct tia_rgb colour, tia_q30 by);

/* Reads a highlight's exponent; an exponent above TIA_EXPONENT_MAX is clamped to it. */
int tia_text_exponent(struct tia_text *t, tia_q16 *out);

/* Sets the Phong highlight. An exponent of 0 means no highlight; one between 0 and 1 becomes 1. */
void tia_set_highlight(struct tia_material *material, struct tia_rgb specular, tia_q16 exponent);

#endif
