#include <tia/raster.h>

#include "math/divisor.h"
#include "math/integer.h"
#include "ranges.h"

#define SMALL_BITS 25
#define SMALL_FRACTION 18

static int bits_of(uint64_t n)
{
    return n ? 64 - (int)tia_clz64(n) : 0;
}

/* Sets the position of sample s of n x n: in a pixel of 2 n^2 columns and rows, column 2 n i + 2 j + 1 and row 2 n j +
 * 2 n - 2 i - 1, where i = s mod n, j = s div n. Counted from the middle of the image, the column is in -W n^2..W n^2;
 * divided by W n^2 it is x/w, and likewise for rows. D is (x/w, y/w, 1) times n^2 W H/gcd(W, H), so that all components
 * are integers. */
static void place(struct tia_raster_grid *l, int32_t n, int32_t sample)
{
    int32_t width = l->width, height = l->height, i = sample % n, j = sample / n;
    int32_t g = (int32_t)common_divisor((uint32_t)width, (uint32_t)height);
    int32_t column = 2 * n * i + 2 * j + 1 - n * n * width, row = n * n * height - (2 * n * j + 2 * n - 2 * i - 1);

    l->x = column * (height / g);
    l->y = row * (width / g);
    l->w = n * n * (width / g) * height;
    l->right = 2 * n * n * (height / g);
    l->down = 2 * n * n * (width / g);
    l->centre[0] = -column * (32768 / (n * n));
    l->centre[1] = row * (32768 / (n * n));
}

/* Returns a bound on |D.x| + |D.y| + |D.w| in the image and a pixel around it: the same for all samples, which
 * therefore have the same vertices. */
static uint64_t reach(const struct tia_raster_grid *l)
{
    int64_t x = (int64_t)l->right * (l->width + 4) / 2, y = (int64_t)l->down * (l->height + 4) / 2;

    return (uint64_t)(x + y + l->w);
}

/* Returns the bound m of NARROW_SQUARE in ranges.h; 2 m^2 is below 2^61, so that normals and their sums fit. */
static int64_t narrow_limit(const struct tia_raster_grid *l)
{
    if (l->projection == TIA_ORTHOGRAPHIC)
        return 0;
    uint64_t limit = tia_sqrt64((UINT64_C(1) << NARROW_SQUARE) / reach(l));
    return (int64_t)(limit < UINT64_C(1) << 30 ? limit : UINT64_C(1) << 30) - 1;
}

static void choose_format(struct tia_raster_grid *l, int range)
{
    int w = bits_of((uint64_t)l->w);

    if (l->projection == TIA_ORTHOGRAPHIC) {
        l->fraction = FLAT_POINT - (range ? range : 1); /* w = 1 is a coordinate too */
        l->scale = 61 - range - w;                      /* 1/t = h w/2^fraction: 2^scale/t is at most 2^61 */
        return;
    }
    bool small = SMALL_BITS - range >= SMALL_FRACTION && reach(l) < 65536;
    l->fraction = (small ? SMALL_BITS : RASTER_POINT) - range;
    l->scale = 62 + l->fraction - 4 - w;
}

int tia_raster_grid_init(struct tia_raster_grid *grid, enum tia_projection projection, unsigned width, unsigned height,
                         uint32_t samples, uint32_t sample, unsigned range)
{
    unsigned most = projection == TIA_ORTHOGRAPHIC ? TIA_RANGE_FLAT : TIA_RANGE_MAX;

    if (!grid || (unsigned)projection > TIA_ORTHOGRAPHIC || !width || width > TIA_SIZE_MAX || !height ||
        height > TIA_SIZE_MAX || range > most || sample >= samples || (samples != 1 && samples != 4 && samples != 16))
        return TIA_ERR_ARGUMENT;
    grid->projection = projection;
    grid->width = (uint16_t)width;
    grid->height = (uint16_t)height;
    place(grid, samples == 16 ? 4 : samples == 4 ? 2 : 1, (int32_t)sample);
    choose_format(grid, (int)range);
    grid->narrow = narrow_limit(grid);
    return TIA_OK;
}
