/* places.h - positions of points in the coordinates of a scene's vertices, and their projections along a light's
 * direction. */
#ifndef TIA_SHADOW_PLACES_H
#define TIA_SHADOW_PLACES_H

#include "flat/light_vertices.h"
#include "shadow_ranges.h"

/* Data for positions in a scene: coordinates like those of vertices, with SEEN_BITS more fraction bits. */
struct tia_places {
    const struct tia_flat_scene *flat;
    const tia_flat_light *light;
    bool parallel;
    int64_t origin[3]; /* position of the light, if it is a point light */
    /* axis: axis of the largest component of the light's direction. scale: the unit across the axis is 2^(SEEN_BITS -
     * scale) units of positions */
    int axis, scale;
    int64_t slope[3], middle[3]; /* the light's slope against the axis, Q.60; middle of all corners across the axis */
};

void tia_places_init(struct tia_places *p, const struct tia_flat_scene *flat, const tia_flat_light *light);

/* Gives the exact position of a vertex. */
void tia_place_of_vertex(const struct tia_places *p, const struct tia_raster_vertex *v, int64_t at[3]);
/* Gives the position of the point of a face that is visible at pixel (x, y), within SEEN_OFF; false when the point is
 * too far away. */
bool tia_place_seen(const struct tia_places *p, int x, int y, uint32_t face, int64_t at[3]);

/* Projects a position along the light's direction onto the plane perpendicular to the axis. Projections of corners are
 * below 2^ACROSS_BITS in magnitude and accurate to ACROSS_OFF. */
void tia_place_across(const struct tia_places *p, const int64_t at[3], int64_t out[2]);

static inline int64_t place_size(int64_t a)
{
    return a < 0 ? -a : a;
}

static inline int place_largest(const int64_t d[3])
{
    int k = place_size(d[1]) > place_size(d[0]);

    return place_size(d[2]) > place_size(d[k]) ? 2 : k;
}

#endif
