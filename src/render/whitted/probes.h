/* probes.h - the means of noise and pictures over a footprint, from several places along its longer edge. */
#ifndef TIA_RENDER_WHITTED_PROBES_H
#define TIA_RENDER_WHITTED_PROBES_H

#include "num/num_ray.h"

#define PIECES 8 /* most parts into which a footprint is cut */

/* A footprint's edges in the texture's cells, with the cell and the position in it, 0..1, of its centre. */
struct print {
    num_length edge[2][3]; /* [0]: the longer edge */
    num_length part[3];
    int32_t cell[3];
};

static inline num_length print_length(const num_length edge[3])
{
    return num_norm3(edge[0], edge[1], edge[2]);
}

/* Compute the mean of a texture; `value` is as from ray_texture. Return false if it is the value at the centre. */
bool mean_of_noise(const struct tia_texture *texture, const struct print *print, num_length value[3]);
bool mean_of_picture(const struct tia_texture *texture, const struct print *print, num_length value[3]);

#endif
