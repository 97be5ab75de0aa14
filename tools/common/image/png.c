/* png.c - writes PNG by libpng: RGB with 8 bits per channel, or with 16. An sBIT chunk marks RGB565 pictures, in which
 * 5, 6 and 5 bits are significant. A specified transfer function is stored as a chunk sRGB, or as a chunk gAMA of 1 for
 * linear light. */
#ifdef TIA_HAVE_PNG

#include <png.h>
#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>

#include "codec.h"
#include "ports.h"

/* State of the encoder: any call of libpng can end in png_failed, which jumps back to the setjmp in the calling
 * function. */
struct png_state {
    png_structp png;
    png_infop info;
};

static void png_failed(png_structp png, png_const_charp message)
{
    struct image *image = png_get_error_ptr(png);
    if (!image->sink.failed)
        (void)snprintf(image->sink.why, PORT_WHY, "%.150s: libpng: %.60s", image->sink.name, message);
    png_longjmp(png, 1);
}

static void png_warned(png_structp png, png_const_charp message)
{
    (void)png;
    (void)message;
}

static void png_bytes(png_structp png, png_bytep bytes, size_t count)
{
    struct image *image = png_get_io_ptr(png);
    if (sink_write(&image->sink, bytes, count))
        png_error(png, "write error");
}

static void png_flushed(png_structp png)
{
    (void)png;
}

static int header(struct image *image, png_structp png, png_infop info)
{
    if (setjmp(png_jmpbuf(png)) != 0)
        return TIA_ERR_DEVICE;
    png_color_8 bits = {.red = 5, .green = 6, .blue = 5};
    png_set_write_fn(png, image, png_bytes, png_flushed);
    png_set_IHDR(png, info, image->width, image->height, image->film.depth == 16 ? 16 : 8, PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (image->film.depth == 0)
        png_set_sBIT(png, info, &bits);
    if (image->film.transfer == IMAGE_SRGB)
        png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_RELATIVE);
    if (image->film.transfer == IMAGE_LINEAR)
        png_set_gAMA(png, info, 1.0);
    png_write_info(png, info);
    return TIA_OK;
}

static int begin(struct image *image)
{
    struct png_state *state = calloc(1, sizeof *state);
    image->state = state;
    if (state) {
        state->png = png_create_write_struct(PNG_LIBPNG_VER_STRING, image, png_failed, png_warned);
        state->info = state->png ? png_create_info_struct(state->png) : NULL;
    }
    if (!state || !state->info) {
        (void)snprintf(image->sink.why, PORT_WHY, "memory: exhausted");
        return TIA_ERR_MEMORY;
    }
    return header(image, state->png, state->info);
}

static int bytes(struct image *image, const unsigned char *row)
{
    struct png_state *state = image->state;
    if (setjmp(png_jmpbuf(state->png)) != 0)
        return TIA_ERR_DEVICE;
    png_write_row(state->png, row);
    return TIA_OK;
}

static int row(struct image *image, const tia_rgb565 *pixels)
{
    image_expand(image->line, pixels, image->width);
    return bytes(image, image->line);
}

/* Switches to storing without compression, so that only the rows' checksums still take time. */
static void hurry(struct image *image)
{
    struct png_state *state = image->state;
    if (setjmp(png_jmpbuf(state->png)) != 0)
        return;
    png_set_compression_level(state->png, 0);
    png_set_filter(state->png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
}

static int end(struct image *image)
{
    struct png_state *state = image->state;
    if (setjmp(png_jmpbuf(state->png)) != 0)
        return TIA_ERR_DEVICE;
    png_write_end(state->png, state->info);
    return TIA_OK;
}

static void release(struct image *image)
{
    struct png_state *state = image->state;
    if (state && state->png)
        png_destroy_write_struct(&state->png, &state->info);
    free(state);
    image->state = NULL;
}

const struct image_codec image_codec_png = {
    .name = "png", .begin = begin, .row = row, .bytes = bytes, .hurry = hurry, .end = end, .free = release};

#else
typedef int image_without_png; /* ISO C requires a declaration in every file */
#endif
