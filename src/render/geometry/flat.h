/* flat.h - functions shared by planes and discs. */
#ifndef TIA_RENDER_GEOMETRY_FLAT_H
#define TIA_RENDER_GEOMETRY_FLAT_H

#include "shape.h"

void flat_prepare(struct prepared_plane *plane, struct tia_vec3 point, struct tia_dir3 normal);

/* Intersects a ray with the infinite plane; false if no intersection has 0 <= t <= limit. */
bool flat_intersect(const struct prepared_plane *plane, const struct ray *ray, num_length limit, num_length *t);

/* Implements `surface` of struct shape_kind: the normal is the plane's. */
void flat_surface(const struct shape *shape, struct num_point point, uint32_t element, struct surface *surface);

/* Gives a point's coordinates along the tangents, from plane->point. */
void flat_uv(const struct prepared_plane *plane, struct num_point point, num_length uv[2]);

#endif
