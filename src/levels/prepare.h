/* prepare.h - a run's constants, from those of the frame and of the row. */
#ifndef TIA_LEVELS_PREPARE_H
#define TIA_LEVELS_PREPARE_H

#include "bounds.h"
#include "render/renderer.h"

/* What a run is made of, in double precision: for the kernels' constants, and for exact.c. */
struct level_fine_cast {
    double a[3], k[3]; /* A'.w s^2 = a[0] s^2 + (a[1] + a[2] x) s + v.v; k s^2 */
    struct level_cast_bounds bounds;
};

struct level_fine_light {
    const struct level_lamp *lamp;
    double g[2], q[2]; /* G.v and -2 Q.v */
    struct level_bounds bounds;
    struct level_fine_cast cast[LEVEL_CASTS];
};

struct level_fine {
    const struct tia_view *view;
    const struct level_row *row;
    uint32_t sphere;
    int first, end;
    bool grey;
    struct level_place place;
    struct level_seen seen;
    struct level_depth depth;
    double emission[3];
    double near31, near63; /* half a level less the bound */
    struct level_fine_light light[LEVEL_LIGHTS];
};

/* The forms of pixels first..end-1, without bounds; false when they are for plain C. */
bool tia_level_fine(const struct tia_view *view, const struct level_row *row, uint32_t sphere, int first, int end,
                    struct level_fine *fine);

static inline const struct span_sphere *level_sphere_of(const struct level_fine *fine)
{
    return &span_view_of(fine->view)->spheres[fine->sphere];
}

/* A row's dithering. */
struct level_dither {
    num_u threshold[8];
    float half[LEVEL_MORE]; /* the same less 1/2, for the kernels */
};

void tia_level_dither(bool on, int y, struct level_dither *dither);

/* The kernels' constants; the bounds must be float's. The run keeps pointers into `dither`. */
void tia_level_run(const struct level_fine *fine, const struct level_dither *dither, struct level_run *run);

#endif
