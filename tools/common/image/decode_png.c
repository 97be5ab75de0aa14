/* decode_png.c - PNG by libpng's simplified interface, which needs no setjmp. */
#ifdef TIA_HAVE_PNG

#include <png.h>
#include <stdlib.h>
#include <string.h>

#include "decode_png.h"

static bool read_rgb(png_image *image, struct image_texels *texels)
{
    image->format = PNG_FORMAT_RGB;
    return png_image_finish_read(image, NULL, texels->rgb, 0, NULL) != 0;
}

static bool read_rgba(png_image *image, struct image_texels *texels)
{
    unsigned char *rgba = malloc((size_t)texels->width * texels->height * 4);
    image->format = PNG_FORMAT_RGBA;
    if (!rgba || png_image_finish_read(image, NULL, rgba, 0, NULL) == 0) {
        free(rgba);
        return false;
    }
    image_split(texels, rgba);
    return true;
}

int image_decode_png(struct image_texels *texels, const void *bytes, size_t length, unsigned side, size_t most,
                     const char **why)
{
    png_image image;
    memset(&image, 0, sizeof image);
    image.version = PNG_IMAGE_VERSION;
    *why = "a damaged PNG file";
    if (png_image_begin_read_from_memory(&image, bytes, length) == 0)
        return TIA_ERR_RANGE;
    image.flags |= PNG_IMAGE_FLAG_16BIT_sRGB; /* as for 8-bit files: values are used unchanged, without a conversion of
                                                 gamma */
    int status = image_room(texels, image.width, image.height, side, most, why);
    bool has_alpha = (image.format & PNG_FORMAT_FLAG_ALPHA) != 0;
    if (!status && !(has_alpha ? read_rgba(&image, texels) : read_rgb(&image, texels))) {
        image_free(texels);
        *why = "a damaged PNG file";
        status = TIA_ERR_RANGE;
    }
    png_image_free(&image);
    return status;
}

#else
typedef int image_decode_without_png; /* ISO C requires a declaration in every file */
#endif
