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

void span_keep_nearer(const struct span_view *spans, uint32_t n, const num_u *t, int count, num_u *best,
                      uint32_t *object)
{
    const struct span_sphere *spheres = spans->spheres;

    for (int i = 0; i < count; i++) {
        if (object[i] == TIA_NO_OBJECT ||
            num_nearer(t[i], spheres[n].t_exponent, best[i], spheres[object[i]].t_exponent)) {
            best[i] = t[i];
            object[i] = n;
        }
    }
}
