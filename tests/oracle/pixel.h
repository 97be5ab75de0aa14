/* pixel.h - the oracle's result for a pixel. */
#ifndef TESTS_ORACLE_PIXEL_H
#define TESTS_ORACLE_PIXEL_H

#include <tia/render.h>

struct oracle_vec {
    double x, y, z;
};

/* A pixel's result and its causes. */
struct oracle_pixel {
    tia_rgb565 colour;
    uint32_t object;    /* an object's index, the number of objects + the index of a light, or TIA_NO_OBJECT */
    uint32_t sphere;    /* the object that would be visible if lights were invisible */
    uint32_t path_hash; /* see tia_debug.path_hash */
    double linear[3];   /* r, g, b before clamping; for general rays the mean of the clamped samples */
    double depth;       /* distance from the eye; infinite for the background */
    /* Least distance of 31c + 0.5 or 63c + 0.5 from an integer, over all channels. Smaller errors, in levels, do not
     * change the colour. */
    double margin;
};

#endif
