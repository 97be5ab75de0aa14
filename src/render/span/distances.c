/* distances.c - the distances of a row's pixels to a sphere, and the nearer of two. */
#include "span.h"

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

#if defined(__GNUC__)
#define NOINLINE __attribute__((noinline))
#else
#define NOINLINE
#endif

/* True if sphere n, at the distance t, is nearer than sphere `other` at u, where these are almost equal. */
static NOINLINE bool is_nearer(const struct tia_view *view, uint32_t n, num_u t, uint32_t other, num_u u, int y, int x)
{
    const struct span_sphere *a = &span_view_of(view)->spheres[n], *b = &span_view_of(view)->spheres[other];
    int order = num_order(t, a->t_exponent, num_distance_doubt(t, a->doubt_shift, a->doubt), u, b->t_exponent,
                          num_distance_doubt(u, b->doubt_shift, b->doubt));

    if (order)
        return order < 0;
    struct exact_picture picture = span_picture_of(view);
    return tia_exact_nearer(&picture, x, y, n, other, NULL);
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
            order = rough ? num_rough_order(t[i], own->t_exponent, best[i], other->t_exponent) : 0;
        }
        if (order < 0 || (order == 0 && is_nearer(view, n, t[i], last, best[i], y, x + i))) {
            best[i] = t[i];
            object[i] = n;
        }
    }
}
