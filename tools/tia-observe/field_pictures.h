/* field_pictures.h - the pictures of a light field, from files: a quilt, a file for each view or module, or a panel's
 * picture. */
#ifndef TOOLS_TIA_OBSERVE_FIELD_PICTURES_H
#define TOOLS_TIA_OBSERVE_FIELD_PICTURES_H

#include <tia/render.h>

#include "common/image/texels.h"

struct pictures {
    unsigned count, width, height; /* number of pictures; size of each */
    unsigned columns, rows;        /* columns and rows of a quilt; 0: each picture has a file */
    struct image_texels *files;
    unsigned file_count;
    char why[400];
};

/* Loads the pictures. `path` is the name of a quilt, with `count` 0; or a name with a pattern for `count` pictures.
 * Returns TIA_OK; or TIA_ERR_DEVICE, TIA_ERR_MEMORY or TIA_ERR_RANGE with the reason in pictures->why. pictures_free is
 * safe afterwards. */
int pictures_load(struct pictures *pictures, const char *path, unsigned count);

/* Loads the single picture of a panel in the same way. */
int pictures_load_one(struct pictures *pictures, const char *path);
void pictures_free(struct pictures *pictures);

/* Returns pixel (x, y) of picture `picture`. */
tia_rgb565 pictures_pixel(const struct pictures *pictures, unsigned picture, unsigned x, unsigned y);

#endif
