#include "decode.h"

#include <stdlib.h>
#include <string.h>

#include "decode_png.h"
#include "decode_stb.h"

static int refuse(const char **why, const char *what)
{
    *why = what;
    return TIA_ERR_RANGE;
}

/* ---- PPM: "P6" or "P3", width, height and the maximum value, then the values ---- */

struct ppm {
    const unsigned char *at, *end;
};

static void skip_blanks(struct ppm *ppm)
{
    while (ppm->at < ppm->end && (*ppm->at == '#' || *ppm->at == ' ' || (*ppm->at >= '\t' && *ppm->at <= '\r'))) {
        if (*ppm->at == '#')
            while (ppm->at < ppm->end && *ppm->at != '\n')
                ppm->at++;
        else
            ppm->at++;
    }
}

/* Reads a number up to 65535; 65536 for anything else. */
static unsigned read_number(struct ppm *ppm)
{
    unsigned value = 0;
    skip_blanks(ppm);
    const unsigned char *start = ppm->at;
    while (ppm->at < ppm->end && *ppm->at >= '0' && *ppm->at <= '9') {
        value = value * 10 + (unsigned)(*ppm->at++ - '0');
        if (value > 65535)
            return 65536;
    }
    return ppm->at > start ? value : 65536;
}

static unsigned take_value(struct ppm *ppm, bool plain, unsigned full)
{
    size_t bytes = full > 255 ? 2 : 1;
    if (plain)
        return read_number(ppm);
    if ((size_t)(ppm->end - ppm->at) < bytes)
        return 65536;
    unsigned value = *ppm->at++;
    return bytes == 1 ? value : value << 8 | *ppm->at++;
}

static int take_values(struct ppm *ppm, bool plain, unsigned full, struct image_texels *texels, const char **why)
{
    size_t count = (size_t)texels->width * texels->height * 3;
    for (size_t i = 0; i < count; i++) {
        unsigned value = take_value(ppm, plain, full);
        if (value > full) {
            image_free(texels);
            return refuse(why, "a damaged PPM file");
        }
        texels->rgb[i] = (unsigned char)((value * 255u + full / 2) / full);
    }
    return TIA_OK;
}

static int decode_ppm(struct image_texels *texels, const unsigned char *bytes, size_t length, unsigned side,
                      size_t most, const char **why)
{
    struct ppm ppm = {bytes + 2, bytes + length};
    bool plain = bytes[1] == '3';
    unsigned width = read_number(&ppm), height = read_number(&ppm), full = read_number(&ppm);
    if (width > 65535 || height > 65535 || full == 0 || full > 65535)
        return refuse(why, "a damaged PPM file");
    ppm.at += !plain && ppm.at < ppm.end; /* skips the single blank before binary values */
    int status = image_room(texels, width, height, side, most, why);
    return !status ? take_values(&ppm, plain, full, texels, why) : status;
}

/* ---- all formats ---- */

static bool is_ppm(const void *bytes, size_t length)
{
    return length >= 2 && (memcmp(bytes, "P6", 2) == 0 || memcmp(bytes, "P3", 2) == 0);
}

static bool is_png(const void *bytes, size_t length)
{
    return length >= 4 && memcmp(bytes, "\x89PNG", 4) == 0;
}

int image_decode(struct image_texels *texels, const void *bytes, size_t length, unsigned side, size_t most,
                 const char **why)
{
    if (is_ppm(bytes, length))
        return decode_ppm(texels, bytes, length, side, most, why);
    if (is_png(bytes, length)) {
#ifdef TIA_HAVE_PNG
        return image_decode_png(texels, bytes, length, side, most, why);
#else
        return refuse(why, "this build reads no PNG files (use PPM)");
#endif
    }
#ifdef TIA_HAVE_STB
    return image_decode_stb(texels, bytes, length, side, most, why);
#else
    return refuse(why, "neither a PNG nor a PPM file (this build reads no others)");
#endif
}

static unsigned luminance(const unsigned char *rgb)
{
    return (77u * rgb[0] + 150u * rgb[1] + 29u * rgb[2] + 128) / 256; /* weights 0.299, 0.587, 0.114, ITU-R BT.601 */
}

static unsigned char value_at(const struct image_texels *texels, size_t i, enum tia_channel channel)
{
    switch (channel) {
    case TIA_CHANNEL_RED:
    case TIA_CHANNEL_GREEN:
    case TIA_CHANNEL_BLUE:
        return texels->rgb[3 * i + (size_t)(channel - TIA_CHANNEL_RED)];
    case TIA_CHANNEL_ALPHA:
        return texels->alpha ? texels->alpha[i] : 255;
    case TIA_CHANNEL_LUMINANCE:
    case TIA_CHANNEL_OPACITY:
    default:
        return (unsigned char)luminance(texels->rgb + 3 * i);
    }
}

/* Reduces the picture to one channel in place: the byte of a texel lies at or before the texel's own colours, so no
 * colour is overwritten before it is read. */
void image_channel(struct image_texels *texels, enum tia_channel channel)
{
    size_t count = (size_t)texels->width * texels->height;
    if (channel == TIA_CHANNEL_OPACITY && texels->alpha)
        channel = TIA_CHANNEL_ALPHA;
    for (size_t i = 0; i < count; i++)
        texels->rgb[i] = value_at(texels, i, channel);
    free(texels->alpha);
    unsigned char *plane = realloc(texels->rgb, count);
    texels->alpha = plane ? plane : texels->rgb;
    texels->rgb = NULL;
}
