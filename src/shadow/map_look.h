/* map_look.h - the share of a light that reaches a point, found with a shadow map by biases and filters, see
 * tia/shadow.h. */
#ifndef TIA_SHADOW_MAP_LOOK_H
#define TIA_SHADOW_MAP_LOOK_H

#include "map.h"
#include "technique.h"

/* The scene's settings for maps, with the defaults in place of 0. */
struct tia_map_look {
    unsigned size;
    enum tia_bias bias;
    int64_t amount; /* Q.16 texels; TIA_BIAS_CONSTANT: TIA_WORLD_BITS fraction bits */
    enum tia_filter filter;
};

void tia_map_look_init(struct tia_map_look *look, const struct tia_scene *scene);

/* Returns the width of a view's border, in texels: more than the largest distance of a tap from the point's texel,
 * except with TIA_FILTER_PCSS. */
unsigned tia_map_border(enum tia_filter filter);

/* A point of a lit face, and its position in the map. */
struct tia_map_point {
    const struct tia_map *map;
    const struct tia_world *world;
    uint32_t face;
    int64_t normal[3];             /* the face's normal, towards the light, Q1.62 */
    const struct tia_map_view *of; /* view of `plane`, or NULL */
    struct tia_map_plane plane;    /* the face's plane; used for TIA_BIAS_PLANE only */
    struct tia_map_spot spot;
    int64_t limit, slack; /* limit: smallest distance of a texel that does not shadow the point; with TIA_BIAS_PLANE the
                             plane's distance less slack */
};

/* Sets the face on which all points lie until the next call. */
void tia_map_face(struct tia_map_point *point, const tia_flat_light *light, uint32_t face);

/* Sets the point's position, with TIA_WORLD_BITS fraction bits, and its limit. */
void tia_map_place(struct tia_map_point *point, const struct tia_map_look *look, const int64_t place[3]);

/* True if texel (i, j) does not shadow the point. Beyond a single view all is lit; beyond a view of a cube the nearest
 * texel at the border decides. */
bool tia_map_tap(const struct tia_map_point *point, int64_t i, int64_t j);

/* Returns the distance at the texel of a tap, TIA_WORLD_BITS fraction bits. */
int64_t tia_map_read(const struct tia_map_point *point, int64_t i, int64_t j);

/* Returns the share of the light that reaches the point, in 0..TIA_SHARE_ALL. The light's radius has TIA_WORLD_BITS
 * fraction bits; `turn` is a number that differs from pixel to pixel. */
unsigned tia_map_share(const struct tia_map_point *point, enum tia_filter filter, int64_t radius, unsigned turn);

/* Bounds of a point's position in a view, and of its limit: two values of each, the lower one first. */
struct tia_map_bounds {
    const struct tia_map_view *view;
    int64_t u[2], v[2]; /* see struct tia_map_spot */
    uint32_t least[2];  /* see tia_map_least */
};

/* Returns the smallest value of a texel that does not shadow a point with this limit. */
uint32_t tia_map_least(const struct tia_map *map, int64_t limit);

/* Returns the share by this number of lit taps. */
unsigned tia_map_part(uint32_t lit, uint32_t taps);

#define TIA_SHARE_UNSURE (2 * TIA_SHARE_ALL)

/* Returns tia_map_share of each point within the bounds, or TIA_SHARE_UNSURE if points may differ; always with
 * TIA_FILTER_PCSS. Not for TIA_BIAS_PLANE, where the limit depends on the texel. */
unsigned tia_map_share_within(const struct tia_map *map, const struct tia_map_bounds *bounds, enum tia_filter filter,
                              unsigned turn);

#endif
