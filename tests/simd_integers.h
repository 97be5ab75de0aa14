/* simd_integers.h - the fixed-point results for a pixel of a run, and for its first light. */
#ifndef TESTS_SIMD_INTEGERS_H
#define TESTS_SIMD_INTEGERS_H

#include "simd/span/prepare.h"

struct simd_integers {
    num_u t;
    bool lit; /* the pixel faces the light; only then the fields below are set */
    struct lit light;
    num_u cosine;
};

static inline struct simd_integers simd_integers_at(const struct simd_fine *f, int x)
{
    const struct span_view *spans = span_view_of(f->view);
    const struct span_sphere *sphere = &spans->spheres[f->sphere];
    struct light_source source = {.sphere = sphere, .light = f->light[0].lamp->light};
    struct light_line line;
    struct simd_integers o;

    span_distances(spans, f->sphere, f->row->y, x, 1, &o.t);
    light_line_prepare(&spans->primary, &source, x, f->row->y, &line);
    line.count = 1;
    o.lit = spans->kernels->light(&line, &o.t, &o.light);
    if (o.lit)
        spans->kernels->lambert(&o.light, sphere->inverse, 1, &o.cosine);
    return o;
}

#endif
