/* surface.h - what the formats of others say of surfaces. */
#ifndef TIA_SRC_READ_SURFACE_H
#define TIA_SRC_READ_SURFACE_H

#include "read/text/text.h"

static inline struct tia_rgb tia_grey(tia_q30 x)
{
    return (struct tia_rgb){x, x, x};
}

/* a b, or as much of it as Q2.30 holds. */
tia_q30 tia_q30_product(tia_q30 a, tia_q30 b);
struct tia_rgb tia_rgb_product(struct tia_rgb colour, tia_q30 by);

/* A highlight's exponent; above TIA_EXPONENT_MAX, and be it 1e9, that. */
int tia_text_exponent(struct tia_text *t, tia_q16 *out);

/* Phong's highlight of a material: with the exponent 0 there is none, up to 1 it is 1. */
void tia_set_highlight(struct tia_material *material, struct tia_rgb specular, tia_q16 exponent);

#endif
