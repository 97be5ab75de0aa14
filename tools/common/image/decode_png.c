/* decode_png.c - PNG by libpng's simplified interface, which needs no setjmp. */
#ifdef TIA_HAVE_PNG

#include <png.h>
#include <stdlib.h>
#include <string.h>

#include "decode_png.h"

int image_decode_png(struct image_texels *texels, const void *bytes, size_t length, unsigned side, size_t most,
                     const char **why)
{
    const png_color black = {0, 0, 0};
    png_image image;
    memset(&image, 0, sizeof image);
    image.version = PNG_IMAGE_VERSION;
    *why = "a damaged PNG file";
    if (png_image_begin_read_from_memory(&image, bytes, length) == 0)
        return TIA_ERR_RANGE;
    image.format = PNG_FORMAT_RGB;
    image.flags |= PNG_IMAGE_FLAG_16BIT_sRGB; /* like 8-bit files: keep the values, convert no gamma */
    int status = image_room(texels, image.width, image.height, side, most, why);
    if (!status && png_image_finish_read(&image, &black, texels->rgb, 0, NULL) == 0) {
        free(texels->rgb);
        texels->rgb = NULL;
        *why = "a damaged PNG file";
        status = TIA_ERR_RANGE;
    }
    png_image_free(&image);
    return status;
}

unsigned char *image_alpha_png(const struct image_texels *texels, const unsigned char *bytes, size_t length)
{
    size_t count = (size_t)texels->width * texels->height;
    png_image image;
    memset(&image, 0, sizeof image);
    image.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_memory(&image, bytes, length) == 0)
        return NULL;
    bool has_alpha = (image.format & PNG_FORMAT_FLAG_ALPHA) != 0;
    image.format = PNG_FORMAT_GA;
    unsigned char *alpha = has_alpha ? malloc(count * 2) : NULL;
    if (alpha && png_image_finish_read(&image, NULL, alpha, 0, NULL) == 0) {
        free(alpha);
        alpha = NULL;
    }
    for (size_t i = 0; alpha && i < count; i++)
        alpha[i] = alpha[2 * i + 1];
    png_image_free(&image);
    return alpha;
}

#else
typedef int image_decode_without_png; /* ISO C wants a declaration in every file */
#endif
