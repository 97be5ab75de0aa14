/* pictures.h - the pictures of a light field, from files: a quilt, one of each view or module, or a panel's. */
#ifndef TOOLS_TIA_OBSERVE_PICTURES_H
#define TOOLS_TIA_OBSERVE_PICTURES_H

#include <tia/render.h>

#include "common/image/texels.h"

struct pictures {
    unsigned count, width, height; /* count; size of each */
    unsigned columns, rows;        /* of a quilt; 0: there is a file for each */
    struct image_texels *files;
    unsigned file_count;
    char why[400];
};

/* Loads `path`, a quilt's name or one with a pattern, for `count` pictures; for a quilt 0. TIA_OK; TIA_ERR_DEVICE,
 * TIA_ERR_MEMORY or TIA_ERR_RANGE with the reason in pictures->why. pictures_free is safe afterwards. */
int pictures_load(struct pictures *pictures, const char *path, unsigned count);

/* Loads a single picture, a panel's, in the same way. */
int pictures_load_one(struct pictures *pictures, const char *path);
void pictures_free(struct pictures *pictures);

/* Returns pixel (x, y) of picture `picture`. */
tia_rgb565 pictures_pixel(const struct pictures *pictures, unsigned picture, unsigned x, unsigned y);

#endif
