/* changes.c - rectangles of a canvas that pages lack, see changes.h. */
#include "changes.h"

#include <stdlib.h>

#include "pages.h"

#define BAND_ROWS 16 /* rows of a band, if that does not give too many bands */

static unsigned larger(unsigned a, unsigned b)
{
    return a > b ? a : b;
}

static unsigned smaller(unsigned a, unsigned b)
{
    return a < b ? a : b;
}

/* Returns all of a band's pixels. */
static struct tia_tile band_of(const struct changes *changes, unsigned band)
{
    unsigned first = band * changes->rows, rows = smaller(changes->damage.height - first, changes->rows);

    return (struct tia_tile){0, (uint16_t)first, changes->damage.width, (uint16_t)rows};
}

/* Returns the rectangle around two, one of which may be empty. */
static struct tia_tile around(struct tia_tile a, struct tia_tile b)
{
    if (!a.width || !b.width)
        return a.width ? a : b;
    unsigned right = larger((unsigned)a.x + a.width, (unsigned)b.x + b.width);
    unsigned bottom = larger((unsigned)a.y + a.height, (unsigned)b.y + b.height);
    unsigned x = smaller(a.x, b.x), y = smaller(a.y, b.y);

    return (struct tia_tile){(uint16_t)x, (uint16_t)y, (uint16_t)(right - x), (uint16_t)(bottom - y)};
}

tia_rgb565 *damage_of_canvas(struct tia_damage *damage, const struct canvas *canvas)
{
    size_t size = tia_damage_size(canvas->width, canvas->height, 1);
    tia_rgb565 *shown = pages_alloc(size);

    if (!shown || tia_damage_init(damage, shown, size, canvas->width, canvas->height)) {
        free(shown);
        return NULL;
    }
    return shown;
}

int changes_resize(struct changes *changes, const struct canvas *canvas)
{
    changes_free(changes);
    changes->rows = larger(BAND_ROWS, (canvas->height + CHANGES_BANDS - 1u) / CHANGES_BANDS);
    changes->bands = (canvas->height + changes->rows - 1) / changes->rows;
    changes->shown = damage_of_canvas(&changes->damage, canvas);
    changes->lacks = malloc(changes->bands * sizeof *changes->lacks);
    if (!changes->shown || !changes->lacks) {
        changes_free(changes);
        return TIA_ERR_MEMORY;
    }
    changes_forget(changes);
    return TIA_OK;
}

void changes_find(struct changes *changes, const struct canvas *canvas)
{
    for (unsigned band = 0; band < changes->bands; band++) {
        struct tia_tile all = band_of(changes, band), area;
        struct tia_surface surface;
        if (canvas_tile(canvas, all, &surface) || !tia_damage_update(&changes->damage, all, &surface, &area))
            continue;
        for (int page = 0; page < CHANGES_PAGES; page++)
            changes->lacks[band][page] = around(changes->lacks[band][page], area);
    }
    tia_damage_complete(&changes->damage);
}

bool changes_take(struct changes *changes, unsigned page, unsigned band, struct tia_tile *area)
{
    *area = changes->lacks[band][page];
    changes->lacks[band][page].width = 0;
    return area->width > 0;
}

void changes_forget(struct changes *changes)
{
    for (unsigned band = 0; band < changes->bands; band++)
        for (int page = 0; page < CHANGES_PAGES; page++)
            changes->lacks[band][page] = band_of(changes, band);
}

void changes_free(struct changes *changes)
{
    free(changes->shown);
    free(changes->lacks);
    *changes = (struct changes){.bands = 0};
}
