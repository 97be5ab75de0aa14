#include "observe.h"

#include <stdlib.h>

static struct eye between(const struct eye *a, const struct eye *b, double part)
{
    return (struct eye){a->x + (b->x - a->x) * part, a->y + (b->y - a->y) * part, a->z + (b->z - a->z) * part};
}

/* A row of what an eye sees; of which picture a column is, column[] says for all rows. */
static void see_row(const struct observation *o, const int *column, unsigned y, tia_rgb565 *row)
{
    const struct pictures *p = &o->pictures;
    unsigned from = (unsigned)((2 * (uint64_t)y + 1) * p->height / (2 * (uint64_t)o->height));

    for (unsigned x = 0; x < o->width; x++) {
        unsigned at = (unsigned)((2 * (uint64_t)x + 1) * p->width / (2 * (uint64_t)o->width));
        row[x] = column[x] < 0 ? 0 : pictures_pixel(p, (unsigned)column[x], at, from);
    }
}

static void place_eye(const struct observation *o, const struct eye *eye, double aside, int *column)
{
    struct eye at = *eye;

    at.x += aside;
    for (unsigned x = 0; x < o->width; x++)
        column[x] = display_picture(&o->display, &at, x, o->width);
}

/* The left eye's red in the right one's picture. */
static void mix(const tia_rgb565 *left, tia_rgb565 *right, unsigned count)
{
    for (unsigned x = 0; x < count; x++)
        right[x] = (tia_rgb565)((left[x] & 0xf800) | (right[x] & 0x07ff));
}

static int draw_frame(const struct observation *o, const struct eye *eye, struct series *series, int *column,
                      tia_rgb565 *row)
{
    bool two = o->apart > 0;
    int status = TIA_OK;

    place_eye(o, eye, two ? -o->apart / 2 : 0, column);
    if (two)
        place_eye(o, eye, o->apart / 2, column + o->width);
    for (unsigned i = 0; i < o->height && !status; i++) {
        unsigned y = image_bottom_up(series->image) ? o->height - 1 - i : i;
        see_row(o, column, y, row);
        if (two)
            see_row(o, column + o->width, y, row + o->width);
        if (two && o->anaglyph)
            mix(row, row + o->width, o->width);
        status = image_band(series->image, two && o->anaglyph ? row + o->width : row, 1);
    }
    return status;
}

int observe(const struct observation *o, struct series *series)
{
    uint32_t frames = series->film.frames;
    int *column = malloc(2 * sizeof *column * o->width);
    tia_rgb565 *row = malloc(2 * sizeof *row * o->width);
    int status = column && row ? TIA_OK : TIA_ERR_MEMORY;

    for (uint32_t i = 0; i < frames && !status; i++) {
        struct eye eye = between(&o->eye, &o->to, frames > 1 ? (double)i / (frames - 1) : 0);
        status = series_begin(series, i);
        status = status ? status : draw_frame(o, &eye, series, column, row);
        status = status ? status : series_end(series);
    }
    free(column);
    free(row);
    if (!status)
        return series_finish(series);
    series_discard(series);
    return status;
}
