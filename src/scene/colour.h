/* colour.h - tests of colours. */
#ifndef TIA_SCENE_COLOUR_H
#define TIA_SCENE_COLOUR_H

#include <tia/vec.h>

static inline bool colour_is_black(const struct tia_rgb *c)
{
    return c->r == 0 && c->g == 0 && c->b == 0;
}

static inline bool colour_is_grey(const struct tia_rgb *c)
{
    return c->r == c->g && c->g == c->b;
}

#endif
