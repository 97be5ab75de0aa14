#include "stored_png.h"

#ifdef TIA_HAVE_PNG

#include <png.h>
#include <setjmp.h>
#include <stdlib.h>
#include <unistd.h>

struct decoder {
    struct stored *stored;
    png_structp png;
    png_infop info;
    png_bytepp rows;
    uint64_t at;
};

/* Any call of libpng can end here, which jumps back to the setjmp of the calling function. */
static void png_failed(png_structp png, png_const_charp message)
{
    struct decoder *d = png_get_error_ptr(png);

    if (!d->stored->why[0])
        (void)stored_failed(d->stored, "a damaged PNG file (%.60s)", message);
    png_longjmp(png, 1);
}

static void png_warned(png_structp png, png_const_charp message)
{
    (void)png;
    (void)message;
}

static void png_bytes(png_structp png, png_bytep bytes, size_t count)
{
    struct decoder *d = png_get_io_ptr(png);

    if (stored_read_at(d->stored, bytes, count, d->at))
        png_error(png, "read error");
    d->at += count;
}

static int read_header(struct decoder *d)
{
    if (setjmp(png_jmpbuf(d->png)) != 0)
        return -1;
    png_set_user_limits(d->png, TIA_SIZE_MAX, TIA_SIZE_MAX);
    png_set_read_fn(d->png, d, png_bytes);
    png_read_info(d->png, d->info);
    struct stored *s = d->stored;
    s->bits = png_get_bit_depth(d->png, d->info);
    s->film.width = png_get_image_width(d->png, d->info);
    s->film.height = png_get_image_height(d->png, d->info);
    s->stride = (uint64_t)s->film.width * 3 * s->bits / 8;
    if (png_get_color_type(d->png, d->info) != PNG_COLOR_TYPE_RGB || (s->bits != 8 && s->bits != 16))
        return stored_failed(s, "not a .png as tia writes it (RGB of 8 or 16 bits)");
    return 0;
}

static int read_rows(struct decoder *d)
{
    struct stored *s = d->stored;

    s->pixels = malloc((size_t)s->stride * s->film.height);
    d->rows = malloc(s->film.height * sizeof *d->rows);
    if (!s->pixels || !d->rows)
        return stored_failed(s, "no memory for it");
    for (unsigned y = 0; y < s->film.height; y++)
        d->rows[y] = s->pixels + (size_t)y * s->stride;
    if (setjmp(png_jmpbuf(d->png)) != 0)
        return -1;
    (void)png_set_interlace_handling(d->png);
    png_read_update_info(d->png, d->info);
    png_read_image(d->png, d->rows);
    png_read_end(d->png, NULL);
    return 0;
}

int stored_open_png(struct stored *s, uint64_t length)
{
    struct decoder *d = calloc(1, sizeof *d);
    int result = -1;

    (void)length;
    if (!d)
        return stored_failed(s, "no memory for it");
    d->stored = s;
    d->png = png_create_read_struct(PNG_LIBPNG_VER_STRING, d, png_failed, png_warned);
    d->info = d->png ? png_create_info_struct(d->png) : NULL;
    if (!d->info)
        (void)stored_failed(s, "no memory for it");
    else
        result = read_header(d) ? -1 : read_rows(d);
    png_destroy_read_struct(&d->png, &d->info, NULL);
    free(d->rows);
    free(d);
    return result;
}

#else
int stored_open_png(struct stored *s, uint64_t length)
{
    (void)length;
    return stored_failed(s, "this build reads no .png files (use .ppm)");
}
#endif
