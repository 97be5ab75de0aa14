/* path_picture.h - the scene with paths drawn into it. */
#ifndef TOOLS_RADIO_PATH_PICTURE_H
#define TOOLS_RADIO_PATH_PICTURE_H

#include "site.h"

/* Draws paths of any links; ends[i] are the transmitter and receiver of path i. Returns FINE, or the exit status after
 * printing the reason. */
int picture_draw(const struct options *options, const struct site *site, struct threads *pool,
                 const struct path_list *paths, struct tia_vec3 (*ends)[2]);

/* Writes `rows` rows of the picture, beginning with `first_row`: the whole picture, or a part of it with `crc` in its
 * header. Returns as picture_draw. */
int picture_write(const struct options *options, const tia_rgb565 *pixels, unsigned first_row, unsigned rows,
                  uint32_t crc);

#endif
