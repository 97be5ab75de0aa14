/* mip.h - smaller copies of a picture, for textures that are averaged over footprints, in integers.
 *
 * After Williams, "Pyramidal parametrics" (1983): level 0 is the picture's texels; the width and the height of each
 * further level are half of those before, rounded down, but at least 1, to a level of 1 x 1. A texel is the mean of the
 * part of the level before that it covers, rounded to nearest. Where a side is odd, it covers parts of texels. */
#ifndef TIA_MIP_H
#define TIA_MIP_H

#include <tia/material.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Returns the number of bytes of the levels from 1 on, of an image or opacity that tia_scene_check accepts: about a
 * third of its texels'. 0 for a picture of one texel; SIZE_MAX if they are more than half of the address space. */
size_t tia_mip_size(const struct tia_texture *texture);

/* Computes the levels from 1 on, one after another, each row by row as `texels`. `levels` has tia_mip_size bytes, and
 * becomes the texture's `mip_levels`. */
void tia_mip_build(const struct tia_texture *texture, uint8_t *levels);

#ifdef __cplusplus
}
#endif

#endif
