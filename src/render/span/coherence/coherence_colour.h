/* coherence_colour.h - the pixels of one material under one light: for coherence.c alone. */
#ifndef TIA_RENDER_SPAN_COHERENCE_COLOUR_H
#define TIA_RENDER_SPAN_COHERENCE_COLOUR_H

#include "coherence_run.h"
#include "scene/colour.h"

/* The colours of a run for the values of N.w/|w|, called lambert: emission + lambert product. */
struct colouring {
    num_u emission[3], product[3];
    bool grey;
    num_u threshold;
};

static void colouring_prepare(const struct tia_view *view, const struct tia_material *material, num_u threshold,
                              struct colouring *c)
{
    const struct span_view *spans = span_view_of(view);
    const struct tia_rgb *colour = &material->colour, *light = &view->lights[0].emission;

    c->grey = spans->grey && colour_is_grey(colour) && colour_is_grey(&material->emission);
    c->emission[0] = num_colour(material->emission.r);
    c->emission[1] = num_colour(material->emission.g);
    c->emission[2] = num_colour(material->emission.b);
    c->product[0] = num_colour_product(num_colour(colour->r), num_colour(light->r));
    c->product[1] = num_colour_product(num_colour(colour->g), num_colour(light->g));
    c->product[2] = num_colour_product(num_colour(colour->b), num_colour(light->b));
    c->threshold = threshold;
}

/* Returns a channel for a value of lambert; side -1 or 1: its lower or upper limit. */
static inline num_u channel_of(const struct colouring *c, int i, num_u lambert, int side)
{
    num_u light = num_colour_product(lambert, c->product[i]);

    if (side < 0)
        light = light > NUM_CHANNEL_DOUBT ? light - NUM_CHANNEL_DOUBT : 0;
    return num_clamp(c->emission[i] + light + (side > 0 ? NUM_CHANNEL_DOUBT : 0));
}

/* Returns the pixel for a value of lambert, or for a limit. */
static tia_rgb565 colour_of(const struct colouring *c, num_u lambert, int side)
{
    num_u half = c->threshold, red = channel_of(c, 0, lambert, side);
    num_u green = c->grey ? red : channel_of(c, 1, lambert, side);
    unsigned r = num_quantise(red, 31, half), g = num_quantise(green, 63, half);
    unsigned b = c->grey ? r : num_quantise(channel_of(c, 2, lambert, side), 31, half);

    return (tia_rgb565)(r << 11 | g << 5 | b);
}

/* True if all values of lambert from low to high, both off by up to `slack`, have the same colour. */
static bool is_one_colour(const struct colouring *c, num_u low, num_u high, num_u slack)
{
    return colour_of(c, (num_u)num_max((num_wide)low - (num_wide)slack, 0), -1) ==
           colour_of(c, num_clamp((num_u)((num_wide)high + (num_wide)slack)), 1);
}

#endif
