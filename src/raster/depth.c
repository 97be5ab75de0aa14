#include "depth.h"

#include "halves.h"

/* Returns f / 2^cut, clamped to 64 bits; where this clamps, nearness is clamped anyway. */
static int64_t wide_cut(wide f, unsigned cut)
{
    if (wide_bits(wide_size(f)) > (int)cut + 63)
        return wide_is_negative(f) ? INT64_MIN : INT64_MAX;
    return cut ? wide_down(f, cut) : (int64_t)wide_low(f);
}

static int64_t cut_at(const struct polygon *p, int x, int y)
{
    return p->narrow ? narrow_form_at(&p->of.narrow_forms.plane, x, y) >> p->depth.cut
                     : wide_cut(wide_form_at(&p->of.wide_forms.plane, x, y), p->depth.cut);
}

/* Returns -1 or 1 if nearness is clamped at its least or its most, 0 if it is not. */
static int side_of(const struct depth_scale *d, int64_t cut)
{
    return (cut > d->most) - (cut < d->least);
}

static bool is_clamped(const struct depth_scale *d, int64_t cut)
{
    return side_of(d, cut) != 0;
}

static int64_t times_scale(const struct depth_scale *d, int64_t cut)
{
    return wide_down(wide_product(cut, (int64_t)d->reciprocal), d->shift);
}

static int64_t unclamped(const struct depth_scale *d, int64_t cut)
{
    return d->zero + times_scale(d, cut);
}

static int64_t scaled(const struct depth_scale *d, int64_t cut)
{
    if (is_clamped(d, cut))
        return cut < d->least ? 0 : DEPTH_MOST;
    return unclamped(d, cut);
}

/* Returns the step of nearness to the next pixel. The step is used only in runs with two pixels that are not clamped;
 * it is then in `least`..`most`. */
static int64_t step_of(const struct polygon *p)
{
    wide x = p->narrow ? wide_product(p->of.narrow_forms.plane.x, 1) : p->of.wide_forms.plane.x;
    int64_t cut = wide_cut(wide_size(x), p->depth.cut);

    if (cut > p->depth.most - p->depth.least)
        return 0;
    return wide_is_negative(x) ? -times_scale(&p->depth, cut) : times_scale(&p->depth, cut);
}

#define LOW 8 /* largest height of a low box, in rows */

/* True if nearness is clamped nowhere in the box, which is tested at the box's corners, as nearness is linear. False
 * for low boxes, which are not tested. */
static bool is_steady(const struct polygon *p)
{
    const struct depth_scale *d = &p->depth;

    return p->y1 - p->y0 > LOW && !is_clamped(d, cut_at(p, p->x0, p->y0)) && !is_clamped(d, cut_at(p, p->x1, p->y0)) &&
           !is_clamped(d, cut_at(p, p->x0, p->y1)) && !is_clamped(d, cut_at(p, p->x1, p->y1));
}

/* Prepares the scale from f to nearness. With det = m 2^bits, 1/2 <= m < 1, the reciprocal is 2^62/m: f/det 2^scale = f
 * reciprocal 2^(scale - 62 - bits). For f in 0..most this is in 0..2^62. In orthographic views, f is clamped at half of
 * `most` on either side of 0. */
void tia_depth_scale_init(struct polygon *p, const struct tia_raster_grid *grid)
{
    struct depth_scale *d = &p->depth;
    bool flat = grid->projection == TIA_ORTHOGRAPHIC;
    int scale = grid->scale, bits = wide_bits(p->det), cut = bits - 1 - scale, shift;
    uint64_t top = (uint64_t)wide_high(wide_up(p->det, (unsigned)(128 - bits)));

    d->reciprocal = (uint64_t)wide_reciprocal(top);
    d->cut = cut > 0 ? (unsigned)cut : 0;
    shift = 62 - scale + bits - (int)d->cut;
    d->shift = shift > 1 ? (unsigned)shift : 1;
    if (cut > 0)
        d->most = (int64_t)(top >> 1) - 1;
    else if (scale >= 62)
        d->most = scale - 62 < bits ? (int64_t)(top >> (64 - bits + scale - 62)) : 0;
    else
        d->most = (int64_t)(top >> (64 - bits) << (62 - scale));
    d->most = flat ? d->most / 2 : d->most;
    d->least = flat ? -d->most : 0;
    d->zero = flat ? DEPTH_MOST / 2 : 0;
    d->step = step_of(p);
    d->steady = is_steady(p);
}

int64_t tia_depth_at(const struct polygon *p, int x, int y)
{
    return scaled(&p->depth, cut_at(p, x, y));
}

struct depth_run tia_depth_run(const struct polygon *p, int y, int x0, int x1)
{
    const struct depth_scale *d = &p->depth;
    int64_t first = cut_at(p, x0, y);

    if (d->steady)
        return (struct depth_run){(uint64_t)unclamped(d, first), (uint64_t)d->step, true};
    int64_t last = x1 - x0 > 1 ? cut_at(p, x1 - 1, y) : first;
    bool steady = !is_clamped(&p->depth, first) && !is_clamped(&p->depth, last);

    return (struct depth_run){(uint64_t)scaled(&p->depth, first), (uint64_t)p->depth.step, steady};
}

/* As nearness is linear, its sides are in order along the row. */
int tia_depth_part(const struct polygon *p, int y, int x0, int x1, struct depth_run *run)
{
    const struct depth_scale *d = &p->depth;
    int64_t first = cut_at(p, x0, y);
    int side = side_of(d, first), same = x0, end = x1 - 1;

    *run = (struct depth_run){(uint64_t)scaled(d, first), side ? 0 : (uint64_t)d->step, true};
    if (side_of(d, cut_at(p, end, y)) == side)
        return x1;
    while (end - same > 1) {
        int middle = same + (end - same) / 2;
        if (side_of(d, cut_at(p, middle, y)) == side)
            same = middle;
        else
            end = middle;
    }
    return end;
}

static struct wide_form plane_of(const struct polygon *p)
{
    const struct narrow_form *f = &p->of.narrow_forms.plane;

    if (!p->narrow)
        return p->of.wide_forms.plane;
    return (struct wide_form){wide_product(f->x, 1), wide_product(f->y, 1), wide_product(f->c, 1)};
}

void tia_depth_plane(const struct polygon *p, struct tia_raster_plane *plane)
{
    struct wide_form f = plane_of(p);

    halves_put(plane->x, f.x);
    halves_put(plane->y, f.y);
    halves_put(plane->c, f.c);
    halves_put(plane->det, p->det);
}

/* Ties are broken as for edges. The three signs together distinguish any two planes: f/det is the same function of the
 * pixel only if x/det, y/det and the value at one pixel are equal. */
int tia_depth_order(const struct polygon *p, const struct tia_raster_plane *plane, int x, int y)
{
    struct wide_form a = plane_of(p), b = {halves_get(plane->x), halves_get(plane->y), halves_get(plane->c)};
    wide det = halves_get(plane->det);
    int order = wide_order_of_products(wide_form_at(&a, x, y), det, wide_form_at(&b, x, y), p->det);

    if (!order)
        order = wide_order_of_products(a.x, det, b.x, p->det);
    if (!order)
        order = wide_order_of_products(a.y, det, b.y, p->det);
    return order;
}
