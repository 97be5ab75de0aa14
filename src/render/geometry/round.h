/* round.h - functions shared by cylinders and cones. */
#ifndef TIA_RENDER_GEOMETRY_ROUND_H
#define TIA_RENDER_GEOMETRY_ROUND_H

#include "shape.h"

/* The elements: the side and the caps. */
enum { ROUND_SIDE, ROUND_BASE, ROUND_TOP };

/* The ends of the axis and the radii at them. One radius may be 0; equal radii make a cylinder. */
struct round_ends {
    struct tia_vec3 base, top;
    tia_q16 base_radius, top_radius;
    struct tia_fine_ends fine;
};

/* Returns the fine digits of a shape; all are 0 if it has none. */
struct tia_fine_ends round_fine(const struct tia_scene *scene, const struct tia_shape *given);

void round_prepare(struct prepared_cone *cone, const struct round_ends *ends, bool capped);

/* Implements `intersect` of struct shape_kind. */
bool round_intersect(const struct shape *shape, const struct ray *ray, num_length limit,
                     struct intersection *intersection);
/* Implements `chord` of struct shape_kind. */
bool round_chord(const struct shape *shape, const struct ray *ray, num_length after, struct chord *chord);
/* Implements `surface` of struct shape_kind. */
void round_surface(const struct shape *shape, struct num_point point, uint32_t element, struct surface *surface);
/* Implements `uv` of struct shape_kind. */
void round_uv(const struct shape *shape, struct num_point point, uint32_t element, num_length uv[2]);

#endif
