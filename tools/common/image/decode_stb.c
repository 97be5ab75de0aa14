/* decode_stb.c - JPEG, BMP, TGA and GIF by stb_image. It is compiled here without SIMD, whose JPEG code decodes to
 * slightly different texels: a file has the same texels on every machine. */
#ifdef TIA_HAVE_STB

#include "decode_stb.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

/* Allocates zeros: a damaged JPEG may use tables that it does not define, and these must not contain old memory. */
#define STBI_MALLOC(size) calloc(1, size)
#define STBI_REALLOC(memory, size) realloc(memory, size)
#define STBI_FREE(memory) free(memory)
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
#pragma GCC diagnostic ignored "-Wunused-function" /* functions of the excluded formats */
#include <stb_image.h>

static int refuse(const char **why, const char *what)
{
    *why = what;
    return TIA_ERR_RANGE;
}

/* Number of zeros behind a file. stb_image reads zeros beyond the end of a file, without an error. To detect that,
 * SPARE zeros are stored after the file; the position after decoding shows if some of them were read. Only stb_image's
 * internal functions give the position. */
#define SPARE 16

static unsigned char *load_padded(const struct image_texels *texels, int channels, const unsigned char *padded,
                                  size_t length)
{
    stbi__context context;
    int width, height, ignored;
    stbi__start_mem(&context, padded, (int)(length + SPARE));
    unsigned char *all = stbi__load_and_postprocess_8bit(&context, &width, &height, &ignored, channels);
    bool is_whole = context.img_buffer <= padded + length;
    if (all && (!is_whole || width != (int)texels->width || height != (int)texels->height)) {
        free(all);
        all = NULL;
    }
    return all;
}

/* Loads a picture with `channels` bytes for each texel, to be freed by free(). Returns NULL if the picture is damaged,
 * or if its size is not that of its header. */
static unsigned char *load(const struct image_texels *texels, int channels, const unsigned char *bytes, size_t length)
{
    unsigned char *padded = calloc(1, length + SPARE);
    unsigned char *all = NULL;
    if (padded) {
        memcpy(padded, bytes, length);
        all = load_padded(texels, channels, padded, length);
    }
    free(padded);
    return all;
}

/* Returns the absolute value: the height in a BMP's header is negative if the top row comes first. */
static uint64_t magnitude(int size)
{
    return size < 0 ? 0 - (uint64_t)size : (uint64_t)size;
}

/* True if the Huffman tables that begin at `at`, of a segment of `length` bytes, have at most 256 codes each. Missing
 * bytes at the end count as zeros. */
static bool are_tables(const unsigned char *at, const unsigned char *end, int64_t length)
{
    while (length > 0 && at < end && at[0] >> 4 <= 1 && (at[0] & 15) <= 3) {
        int codes = 0;
        for (int i = 1; i <= 16 && i < end - at; i++)
            codes += at[i];
        if (codes > 256)
            return false;
        if (end - at < 17 + codes)
            return true;
        at += 17 + codes;
        length -= 17 + codes;
    }
    return true;
}

/* True if stb_image can read the file safely: version 2.27 writes beyond its array for a Huffman table with more than
 * 256 codes, which no valid JPEG has. Searches for such a table wherever a segment with tables might begin, since
 * stb_image may find segments that other decoders do not. */
static bool is_safe(const unsigned char *bytes, size_t length)
{
    const unsigned char *end = bytes + length;
    if (length == 0 || bytes[0] != 0xff)
        return true;
    for (const unsigned char *at = bytes; end - at > 4; at++)
        if (at[0] == 0xff && at[1] == 0xc4 && !are_tables(at + 4, end, (at[2] << 8 | at[3]) - 2))
            return false;
    return true;
}

int image_decode_stb(struct image_texels *texels, const unsigned char *bytes, size_t length, unsigned side, size_t most,
                     const char **why)
{
    int width, height, channels;
    if (length > INT_MAX - SPARE || !is_safe(bytes, length) ||
        stbi_info_from_memory(bytes, (int)length, &width, &height, &channels) == 0)
        return refuse(why, "not a PNG, PPM, JPEG, BMP, TGA or GIF file, or a damaged one");
    int status = image_room(texels, magnitude(width), magnitude(height), side, most, why);
    if (status)
        return status;
    bool has_alpha = channels % 2 == 0;
    unsigned char *all = load(texels, has_alpha ? 4 : 3, bytes, length);
    if (!all) {
        image_free(texels);
        return refuse(why, "a damaged JPEG, BMP, TGA or GIF file");
    }
    if (has_alpha) {
        image_split(texels, all);
    } else {
        free(texels->rgb);
        texels->rgb = all;
    }
    return TIA_OK;
}

#else
typedef int image_decode_without_stb; /* ISO C requires a declaration in every file */
#endif
