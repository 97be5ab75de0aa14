/* palette.h - false colours. */
#ifndef TOOLS_VIEWS_PALETTE_H
#define TOOLS_VIEWS_PALETTE_H

#include <stdint.h>
#include <tia/vec.h>

/* Returns a colour on a scale from black over blue, red and yellow to white, for t in 0..1. */
tia_rgb565 palette_heat(double t);

/* Returns the colour of number n, chosen so that successive numbers differ most. */
tia_rgb565 palette_number(uint32_t n);

/* Returns a colour from channels in 0..1, clamped. */
tia_rgb565 palette_rgb(double r, double g, double b);

#endif
