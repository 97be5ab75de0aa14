/* decode_stb.c - JPEG, BMP, TGA and GIF by stb_image. It is compiled here and without vector units, whose code for
 * JPEG gives other texels: so the same file is the same picture on every machine. */
#ifdef TIA_HAVE_STB

#include "decode_stb.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_SIMD
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STBI_NO_HDR
#define STBI_ONLY_JPEG
#define STBI_ONLY_BMP
#define STBI_ONLY_TGA
#define STBI_ONLY_GIF
#pragma GCC diagnostic ignored "-Wunused-function" /* what it declares for the formats that are left out */
#include <stb_image.h>

static int refuse(const char **why, const char *what)
{
    *why = what;
    return TIA_ERR_RANGE;
}

/* stb_image takes what is missing at the end of a file as zeros: the source knows whether it was asked for more. */
struct source {
    const unsigned char *at;
    size_t left;
    bool cut;
};

static int source_read(void *ctx, char *out, int size)
{
    struct source *source = ctx;
    size_t count = (size_t)size < source->left ? (size_t)size : source->left;
    source->cut |= count == 0;
    memcpy(out, source->at, count);
    source->at += count;
    source->left -= count;
    return (int)count;
}

static void source_skip(void *ctx, int count)
{
    struct source *source = ctx;
    size_t most = count > 0 ? (size_t)count : 0, some = most < source->left ? most : source->left;
    source->cut |= some < most;
    source->at += some;
    source->left -= some;
}

static int source_eof(void *ctx)
{
    const struct source *source = ctx;
    return source->left == 0;
}

/* Red, green, blue and alpha of each texel; free() them. NULL: the picture is damaged, or not as large as its
 * header says. */
static unsigned char *load(const struct image_texels *texels, const unsigned char *bytes, size_t length)
{
    static const stbi_io_callbacks calls = {source_read, source_skip, source_eof};
    struct source source = {bytes, length, false};
    int width, height, channels;
    unsigned char *all = stbi_load_from_callbacks(&calls, &source, &width, &height, &channels, 4);
    if (all != NULL && (source.cut || width != (int)texels->width || height != (int)texels->height)) {
        free(all);
        all = NULL;
    }
    return all;
}

/* What is transparent is laid on black. */
static void lay(struct image_texels *texels, const unsigned char *all)
{
    for (size_t i = 0; i < (size_t)texels->width * texels->height; i++, all += 4) {
        for (size_t c = 0; c < 3; c++) {
            texels->rgb[3 * i + c] = (unsigned char)((all[c] * all[3] + 127) / 255);
        }
    }
}

/* Of rows from the top down, a BMP's header gives the height negative. */
static uint64_t magnitude(int size)
{
    return size < 0 ? 0 - (uint64_t)size : (uint64_t)size;
}

int image_decode_stb(struct image_texels *texels, const unsigned char *bytes, size_t length, unsigned side, size_t most,
                     const char **why)
{
    int width, height, channels;
    if (length > INT_MAX || stbi_info_from_memory(bytes, (int)length, &width, &height, &channels) == 0) {
        return refuse(why, "no PNG, PPM, JPEG, BMP, TGA or GIF file, or a damaged one");
    }
    int status = image_room(texels, magnitude(width), magnitude(height), side, most, why);
    if (status != TIA_OK) {
        return status;
    }
    unsigned char *all = load(texels, bytes, length);
    if (all == NULL) {
        free(texels->rgb);
        texels->rgb = NULL;
        return refuse(why, "a damaged JPEG, BMP, TGA or GIF file");
    }
    lay(texels, all);
    free(all);
    return TIA_OK;
}

unsigned char *image_alpha_stb(const struct image_texels *texels, const unsigned char *bytes, size_t length)
{
    int width, height, channels;
    size_t count = (size_t)texels->width * texels->height;
    if (stbi_info_from_memory(bytes, (int)length, &width, &height, &channels) == 0 || channels % 2 != 0) {
        return NULL;
    }
    unsigned char *all = load(texels, bytes, length);
    for (size_t i = 0; all != NULL && i < count; i++) {
        all[i] = all[4 * i + 3];
    }
    return all;
}

#else
typedef int image_decode_without_stb; /* ISO C wants a declaration in every file */
#endif
