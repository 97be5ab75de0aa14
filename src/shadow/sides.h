/* sides.h - the sides of faces on which lights and the eye are, in exact integers. */
#ifndef TIA_SHADOW_SIDES_H
#define TIA_SHADOW_SIDES_H

#include "flat/light_vertices.h"

/* Returns corner number k of a face. */
static inline const struct tia_raster_vertex *tia_face_corner(const struct tia_flat_scene *flat,
                                                              const struct tia_flat_face *face, unsigned k)
{
    return &flat->points[face->corner[k]];
}

/* Returns the sign of (a x b).c. Components are below 2^41 in magnitude, so the product is below 2^126. */
int tia_flat_orientation(const int64_t a[3], const int64_t b[3], const int64_t c[3]);

/* Returns the side of a face's plane on which the light is: 1 where the corners run counterclockwise seen from the
 * light, -1 on the opposite side, 0 in the plane. */
int tia_flat_side(const struct tia_flat_scene *flat, const struct tia_flat_face *face, const tia_flat_light *light);

/* Returns the side of a face's plane on which the eye is, as tia_flat_side does. */
int tia_flat_side_of_eye(const struct tia_flat_scene *flat, const struct tia_flat_face *face);

/* True if the visible side of a face is the side `side`, as tia_flat_side returns it. */
bool tia_flat_is_visible(const struct tia_flat_scene *flat, uint32_t face, int side);

/* True if the visible side of a face is turned to the light. */
bool tia_flat_is_turned(const struct tia_flat_scene *flat, uint32_t face, const tia_flat_light *light);

/* True if the object cannot hide the light from any visible point: it is a plane, with the eye and the light on the
 * same side. */
bool tia_flat_hides_nothing(const struct tia_flat_scene *flat, const struct tia_flat_object *object,
                            const tia_flat_light *light);

/* True if the object's silhouette suffices. If the light and the eye are outside a closed surface, only the faces
 * turned to the light need to cast volumes, with sides only at their silhouette. The reason: the segment from a visible
 * point to the light starts and ends outside, so it crosses as many faces turned to the light as others, even if the
 * surface crosses itself, and however it is oriented. Otherwise each face casts a volume of its own, which is correct
 * for any faces. */
bool tia_flat_has_silhouette(const struct tia_flat_scene *flat, const struct tia_flat_object *object,
                             const tia_flat_light *light);

#endif
