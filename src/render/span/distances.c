/* distances.c - the pixels of a row that show a sphere, their distances, and the nearer of two. */
#include "math/fast.h"

#include "math/noinline.h"
#include "span.h"

static bool shows(const struct tia_view *view, int x, int y, uint32_t object)
{
    struct exact_picture picture = span_picture_of(view);

    return tia_exact_meets(&picture, x, y, object);
}

struct span span_sphere_row(const struct tia_view *view, uint32_t object, int y, struct span guess)
{
    const struct primary_rays *primary = &span_view_of(view)->primary;
    const struct span_sphere *sphere = &span_view_of(view)->spheres[object];
    num_wide row = primary_y(primary, y);
    struct cone_row s = {sphere->centre.x,
                         sphere->centre.y * row - sphere->centre.z * primary->depth,
                         num_square(row) + num_square(primary->depth),
                         sphere->c,
                         primary->exponent,
                         primary->width,
                         sphere->cone_doubt,
                         shows,
                         view,
                         object,
                         y};

    return cone_row_span(&s, guess);
}

void span_distances(const struct span_view *spans, uint32_t n, int y, int x, int count, num_u *t)
{
    const struct span_sphere *sphere = &spans->spheres[n];
    struct sphere_line line;

    span_sphere_line(&spans->primary, sphere, y, x, &line);
    line.count = count;
    if (sphere->c < 0)
        spans->kernels->sphere_inside(&line, t);
    else
        spans->kernels->sphere(&line, t);
}

/* Returns -1 if the distance t of sphere a is smaller than u of sphere b, 1 if not, and 0 if these, off by less than
 * their doubts, leave it open. */
static ONCE_IN_FLASH int order_of(const struct span_sphere *a, num_u t, num_u t_doubt, const struct span_sphere *b,
                                  num_u u, num_u u_doubt)
{
    return num_order(t, a->t_exponent, t_doubt, u, b->t_exponent, u_doubt);
}

/* True if sphere n, at the distance t, is nearer than sphere `other` at u, where these are almost equal. */
static NOINLINE bool is_nearer(const struct tia_view *view, uint32_t n, num_u t, uint32_t other, num_u u, int y, int x)
{
    const struct span_sphere *a = &span_view_of(view)->spheres[n], *b = &span_view_of(view)->spheres[other];
    int order = order_of(a, t, num_distance_doubt(t, a->doubt_shift, a->doubt), b, u,
                         num_distance_doubt(u, b->doubt_shift, b->doubt));

    if (order || view_stops(view)) /* balls take tens of thousands of instructions */
        return order < 0;
    struct exact_picture picture = span_picture_of(view);
    return tia_exact_nearer(&picture, x, y, n, other);
}

void span_keep_nearer(const struct tia_view *view, uint32_t n, int y, int x, const num_u *t, int count, num_u *best,
                      uint32_t *object)
{
    const struct span_sphere *spheres = span_view_of(view)->spheres, *own = &spheres[n], *other = own;
    uint32_t last = TIA_NO_OBJECT;

    for (int i = 0; i < count; i++) {
        int order = -1;
        if (object[i] != last) {
            last = object[i];
            other = last == TIA_NO_OBJECT ? own : &spheres[last];
        }
        if (last != TIA_NO_OBJECT) {
            bool rough = span_is_accurate(own, t[i]) && span_is_accurate(other, best[i]);
            order = rough ? order_of(own, t[i], t[i] / 128 + 1, other, best[i], best[i] / 128 + 1) : 0;
        }
        if (order < 0 || (order == 0 && is_nearer(view, n, t[i], last, best[i], y, x + i))) {
            best[i] = t[i];
            object[i] = n;
        }
    }
}
