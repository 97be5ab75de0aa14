/* map.h - shadow maps (Williams 1978): the distance from a light to the nearest face at each texel, and a point's
 * position among the texels.
 *
 * A map has views of size x size texels: either one, whose rays are parallel or go through one point, or six, which
 * look both ways along the world's axes. The rasteriser draws the faces into the views: corners are rounded once more,
 * to the view's own vertices, and the distance of the face that is nearest at the middle of a texel is rounded once.
 * Distances are measured along the view's axis, so they are linear in space. */
#ifndef TIA_SHADOW_MAP_H
#define TIA_SHADOW_MAP_H

#include "flat/world.h"
#include "scene/cancel.h"

#define TIA_CUBE_VIEWS 6
#define TIA_MAP_NOTHING UINT32_MAX
#define TIA_MAP_FAR (UINT32_MAX - 1) /* smallest distance that is beyond every corner */

struct tia_map_view {
    struct tia_eye eye; /* the view's matrix, for 256 times the coordinates of tia_flat_affine */
    struct tia_raster_grid grid;
    int64_t axes[3][3];    /* right, up and forward, Q1.62 */
    uint32_t *distance;    /* TIA_MAP_NOTHING where there is no face */
    struct tia_tile drawn; /* the texels that are drawn; others are undefined */
};

struct tia_map {
    struct tia_map_view view[TIA_CUBE_VIEWS];
    unsigned view_count, size;
    bool parallel;
    int64_t origin[3]; /* position of the light, or of distance 0 along parallel rays; TIA_WORLD_BITS fraction bits */
    int64_t density;   /* texels per unit, for a point light at the distance 1: Q.40 */
    int bits;          /* coordinates of vertices are below 2^bits */
    int unit;          /* vertices are in units of 2^unit */
    int coarse;        /* distances are in units of 2^(coarse - TIA_WORLD_BITS) */
};

/* The light of a map, see tia_flat_light_at. */
struct tia_map_light {
    const struct tia_light *light;
    tia_flat_light at;
};

/* Returns the number of views in a light's map. */
unsigned tia_map_views(const struct tia_light *light);

/* Prepares a map without distances, of which all texels will be drawn. Its views have `border` texels on each side
 * beyond those that the light needs. Returns TIA_OK or an error. */
int tia_map_init(struct tia_map *map, const struct tia_world *world, const struct tia_map_light *light, unsigned size,
                 unsigned border);

/* Returns the number of bytes of working memory for tia_map_draw. */
uint64_t tia_map_room(unsigned size, uint32_t faces);

/* Draws the distances; `runs` are the rasteriser's inner loops, or NULL. TIA_STOPPED when cancelled. */
int tia_map_draw(const struct tia_map *map, const struct tia_flat_scene *flat, void *room,
                 const struct tia_raster_runs *runs, struct cancel *cancel);

/* Gives the corners of a face in a view; returns the number of corners. */
unsigned tia_map_corners(const struct tia_map *map, const struct tia_map_view *view, const struct tia_flat_scene *flat,
                         uint32_t face, struct tia_raster_vertex corners[TIA_SIDES]);

/* A face's plane: raster.h's f at texel (i, j) is x i + y j + c, in units for which it has at most 62 bits. */
struct tia_map_plane {
    int64_t x, y, c;
    int64_t factor; /* distances are factor/f, or for parallel rays the product factor f */
    int places;     /* number of fraction bits of these distances, in the map's unit */
};

void tia_map_plane_init(struct tia_map_plane *plane, const struct tia_map *map, const struct tia_map_view *view,
                        const struct tia_raster_plane *given);

/* Returns the distance of the plane at the middle of texel (i, j), rounded; the relative error before rounding is below
 * 2^-30. Returns 0 where the plane is not in front of the light. */
uint32_t tia_map_distance(const struct tia_map *map, const struct tia_map_plane *plane, int i, int j);

/* A point's position in a map. */
struct tia_map_spot {
    const struct tia_map_view *view;
    int64_t u, v;     /* column and row in texels, Q.16, from the upper left corner; within 2^40 of the map's middle */
    int64_t distance; /* TIA_WORLD_BITS fraction bits */
    int64_t texel;    /* size of a texel at this distance, TIA_WORLD_BITS fraction bits */
};

/* Finds the position in a map of a point with TIA_WORLD_BITS fraction bits. */
void tia_map_find(const struct tia_map *map, const int64_t place[3], struct tia_map_spot *spot);

#endif
