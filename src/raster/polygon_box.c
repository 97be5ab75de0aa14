#include "polygon.h"
#include "ranges.h"

struct reach {
    int32_t x0, x1, y0, y1; /* in units of 2^-16 pixel, from the centre of pixel (0, 0) */
};

/* Returns a/w times half the image's width or height, `size`, in 2^-16 pixel, clamped to just outside the image. w > 0.
 * `reciprocal` is 2^63/(w 2^zeros / 2^32), with a relative error below 1.04 2^-31. So the quotient's error is below
 * 2^-29, at most half a unit of the result. The result is then rounded down, see tests/proofs/raster_rows.g. */
static int32_t along(int64_t a, int64_t w, unsigned zeros, uint32_t reciprocal, int32_t size)
{
    uint64_t n = a < 0 ? 0 - (uint64_t)a : (uint64_t)a, quotient;

    if (n >= (uint64_t)w)
        return a < 0 ? -(size + 1) * 32768 : (size + 1) * 32768;
    quotient = tia_mul_u32((uint32_t)(n << zeros >> 32), reciprocal) >> 31;
    int32_t part = (int32_t)(quotient * (uint32_t)size >> 17);
    return a < 0 ? -part : part;
}

static void include_corner(struct reach *r, const struct tia_raster_grid *l, const struct tia_raster_vertex *v)
{
    unsigned zeros = tia_clz64((uint64_t)v->w);
    uint32_t reciprocal = tia_reciprocal((uint32_t)((uint64_t)v->w << zeros >> 32));
    int32_t x = l->centre[0] + along(v->x, v->w, zeros, reciprocal, l->width);
    int32_t y = l->centre[1] - along(v->y, v->w, zeros, reciprocal, l->height);

    r->x0 = x < r->x0 ? x : r->x0;
    r->x1 = x > r->x1 ? x : r->x1;
    r->y0 = y < r->y0 ? y : r->y0;
    r->y1 = y > r->y1 ? y : r->y1;
}

static void narrow_to(int *low, int *high, int32_t from, int32_t to, int more)
{
    int first = (int)((from - BOX_MARGIN + 65535) >> 16) - more, end = (int)((to + BOX_MARGIN) >> 16) + 1 + more;

    *low = first > *low ? first : *low;
    *high = end < *high ? end : *high;
}

/* True if all corners are beyond the same side of the image, or none is in front of the eye. The same then holds for
 * all points between the corners, so no pixel is covered. */
static bool is_outside(const struct tia_raster_vertex *v, unsigned count, const struct tia_raster_grid *l, int64_t more)
{
    int64_t width = l->width, height = l->height, sides = 2 * more;
    unsigned left = 0, right = 0, above = 0, below = 0, behind = 0;

    for (unsigned i = 0; i < count; i++) {
        int64_t x = v[i].x * width, w = v[i].w * (width + sides), y = v[i].y * height, h = v[i].w * (height + sides);
        left += x < -w;
        right += x > w;
        above += y > h;
        below += y < -h;
        behind += v[i].w <= 0;
    }
    return left == count || right == count || above == count || below == count || behind == count;
}

bool tia_polygon_box(struct polygon *p, const struct tia_raster_grid *grid, struct tia_tile area,
                     const struct tia_raster_vertex *corners, unsigned count, unsigned more)
{
    struct reach r = {INT32_MAX, INT32_MIN, INT32_MAX, INT32_MIN};
    bool behind = false;

    p->x0 = (int)area.x;
    p->x1 = (int)(area.x + area.width);
    p->y0 = (int)area.y;
    p->y1 = (int)(area.y + area.height);
    if (is_outside(corners, count, grid, more))
        return false;
    for (unsigned i = 0; i < count; i++)
        behind |= corners[i].w <= 0;
    if (behind)
        return true;
    for (unsigned i = 0; i < count; i++)
        include_corner(&r, grid, &corners[i]);
    narrow_to(&p->x0, &p->x1, r.x0, r.x1, (int)more);
    narrow_to(&p->y0, &p->y1, r.y0, r.y1, (int)more);
    return p->x0 < p->x1 && p->y0 < p->y1;
}
