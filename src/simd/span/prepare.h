/* prepare.h - computes a run's constants from those of the frame and of the row. */
#ifndef TIA_SIMD_SPAN_PREPARE_H
#define TIA_SIMD_SPAN_PREPARE_H

#include "bounds.h"
#include "render/renderer.h"

/* The forms of a run, in double precision: for the kernels' constants, and for exact.c. */
struct simd_fine_cast {
    double a[3], k[3]; /* A'.w s^2 = a[0] s^2 + (a[1] + a[2] x) s + v.v; k s^2 likewise */
    struct simd_cast_bounds bounds;
};

struct simd_fine_light {
    const struct simd_lamp *lamp;
    double g[2], q[2]; /* coefficients of G.v and -2 Q.v */
    struct simd_bounds bounds;
    int first; /* of its casters in `cast` of struct simd_fine */
};

struct simd_fine {
    const struct tia_view *view;
    const struct simd_row *row;
    uint32_t sphere;
    int first, end;
    bool grey;
    struct simd_place place;
    struct simd_seen seen;
    struct simd_depth depth;
    double emission[3];
    double near31, near63; /* half a level less the error bound, for 31 and 63 levels */
    int lights, casts;     /* lights that arrive somewhere, and all their casters */
    struct simd_fine_light light[SIMD_LIGHTS];
    struct simd_fine_cast cast[SIMD_CASTS];
};

/* Gives the forms of pixels first..end-1 without lights and bounds; false when these pixels are drawn one by one. */
bool tia_simd_fine_place(const struct tia_view *view, const struct simd_row *row, uint32_t sphere, int first, int end,
                         struct simd_fine *fine);

/* Adds the forms of a light, unless it is black. The lamp must outlive them. */
void tia_simd_fine_light(struct simd_fine *fine, const struct simd_lamp *lamp);

/* Gives the forms of pixels first..end-1 with the sphere's lamps, one for each light, without bounds; false when these
 * pixels are drawn one by one. */
bool tia_simd_fine(const struct tia_view *view, const struct simd_row *row, uint32_t sphere,
                   const struct simd_lamp *lamps, int first, int end, struct simd_fine *fine);

static inline struct simd_fine_cast *simd_casts_of(struct simd_fine *fine, int light)
{
    return &fine->cast[fine->light[light].first];
}

static inline const struct span_sphere *simd_sphere_of(const struct simd_fine *fine)
{
    return &span_view_of(fine->view)->spheres[fine->sphere];
}

/* Thresholds of a row's dithering. */
struct simd_dither {
    num_u threshold[THRESHOLDS];
    float half[SIMD_MORE]; /* the thresholds less 1/2, repeated, for the kernels */
};

void tia_simd_dither(bool on, int y, struct simd_dither *dither);

/* Gives the kernels' constants; the bounds of `fine` must be those for floats. The run points into `dither`. */
void tia_simd_run(const struct simd_fine *fine, const struct simd_dither *dither, struct simd_run *run);

/* Gives parts of them: all but lights and levels; those of lights; those of levels. */
void tia_simd_run_place(const struct simd_fine *fine, const struct simd_dither *dither, struct simd_run *run);
void tia_simd_run_lights(const struct simd_fine *fine, struct simd_run *run);
void tia_simd_run_levels(const struct simd_fine *fine, const struct simd_dither *dither, struct simd_run *run);

#endif
