#include "eye_views.h"

#include <stdlib.h>

static struct eye between(const struct eye *a, const struct eye *b, double part)
{
    return (struct eye){a->x + (b->x - a->x) * part, a->y + (b->y - a->y) * part, a->z + (b->z - a->z) * part};
}

/* An eye in a frame of the film, and the pictures that it sees. */
struct sight {
    struct eye at;
    int *column; /* view or module of each column, the same in all rows */
};

/* Returns a pixel of a panel with lenses: each channel comes from a different subpixel. */
static tia_rgb565 see_lenses(const struct observation *o, const struct eye *eye, unsigned x, unsigned from)
{
    static const tia_rgb565 masks[] = {0xf800, 0x07e0, 0x001f};
    double point = (2.0 * x + 1) / (2.0 * o->width), part = display_part(&o->display, eye, point);
    unsigned seen = 0;

    for (unsigned channel = 0; channel < 3; channel++) {
        int column = panel_column(&o->panel, from, channel, point, part);
        seen |= column < 0 ? 0 : pictures_pixel(&o->pictures, 0, (unsigned)column, from) & masks[channel];
    }
    return (tia_rgb565)seen;
}

static tia_rgb565 see_pictures(const struct observation *o, int picture, unsigned x, unsigned from)
{
    unsigned at = (unsigned)((2 * (uint64_t)x + 1) * o->pictures.width / (2 * (uint64_t)o->width));

    return picture < 0 ? 0 : pictures_pixel(&o->pictures, (unsigned)picture, at, from);
}

static void see_row(const struct observation *o, const struct sight *sight, unsigned y, tia_rgb565 *row)
{
    unsigned from = (unsigned)((2 * (uint64_t)y + 1) * o->pictures.height / (2 * (uint64_t)o->height));

    for (unsigned x = 0; x < o->width; x++)
        row[x] = o->lenses ? see_lenses(o, &sight->at, x, from) : see_pictures(o, sight->column[x], x, from);
}

static void place_eye(const struct observation *o, const struct eye *eye, double aside, struct sight *sight)
{
    sight->at = *eye;
    sight->at.x += aside;
    for (unsigned x = 0; x < o->width && !o->lenses; x++)
        sight->column[x] = display_picture(&o->display, &sight->at, x, o->width);
}

/* Copies the left eye's red into the right eye's picture. */
static void mix(const tia_rgb565 *left, tia_rgb565 *right, unsigned count)
{
    for (unsigned x = 0; x < count; x++)
        right[x] = (tia_rgb565)((left[x] & 0xf800) | (right[x] & 0x07ff));
}

static int draw_frame(const struct observation *o, const struct eye *eye, struct series *series, int *column,
                      tia_rgb565 *row)
{
    struct sight left = {.column = column}, right = {.column = column + o->width};
    bool two = o->apart > 0;
    int status = TIA_OK;

    place_eye(o, eye, two ? -o->apart / 2 : 0, &left);
    if (two)
        place_eye(o, eye, o->apart / 2, &right);
    for (unsigned i = 0; i < o->height && !status; i++) {
        unsigned y = image_bottom_up(series->image) ? o->height - 1 - i : i;
        see_row(o, &left, y, row);
        if (two)
            see_row(o, &right, y, row + o->width);
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
