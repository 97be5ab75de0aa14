/* drawn.c - the part of a shadow map that visible points can look up: the faces that are turned to the light are
 * clipped to the eye's view and to those of the map. Only margins depend on roundings.
 *
 * Faces are polygons of homogeneous points, whose fourth coordinate is 1, or 0 for directions: so planes need no case
 * of their own. */
#include "drawn.h"

#include "shadow/volume.h"
#include "simd/rays/sure_numbers.h"

#define CORNERS 16           /* a face has 4; each of 8 planes adds one */
#define WIDER (1 + 1.0 / 64) /* views are clipped to this multiple of their width */
#define MARGIN 16            /* texels around the points: more than any tap's distance */
#define NEARLY_AT 1e-6 /* a distance from the light, relative to the corner's size, at which a view is drawn whole */

struct corner4 {
    double v[4];
};

struct region {
    double low[2], high[2]; /* texels */
};

static double value(const double plane[4], const struct corner4 *c)
{
    return plane[0] * c->v[0] + plane[1] * c->v[1] + plane[2] * c->v[2] + plane[3] * c->v[3];
}

/* Clips a polygon to the side of a plane where its value is at least 0; returns the number of corners. */
static int clip(struct corner4 corners[CORNERS], int count, const double plane[4])
{
    struct corner4 out[CORNERS];
    int used = 0;

    for (int i = 0; i < count; i++) {
        const struct corner4 *a = &corners[i], *b = &corners[i + 1 < count ? i + 1 : 0];
        double at_a = value(plane, a), at_b = value(plane, b);
        if (at_a >= 0 && used < CORNERS)
            out[used++] = *a;
        if ((at_a >= 0) == (at_b >= 0) || used == CORNERS)
            continue;
        double part = at_a / (at_a - at_b);
        for (int k = 0; k < 4; k++)
            out[used].v[k] = a->v[k] + part * (b->v[k] - a->v[k]);
        used++;
    }
    for (int i = 0; i < used; i++)
        corners[i] = out[i];
    return used;
}

/* Clips a polygon to |x|, |y| <= width times coordinate `depth`. */
static int clip_to_window(struct corner4 corners[CORNERS], int count, int depth, double width)
{
    for (int side = 0; side < 4 && count; side++) {
        double plane[4] = {0, 0, 0, 0};
        plane[side / 2] = side % 2 ? -1 : 1;
        plane[depth] = width;
        count = clip(corners, count, plane);
    }
    return count;
}

/* Gives the visible part of a face, in the world's axes and units, relative to the light's position. */
static int visible_part(const struct tia_map *map, const struct tia_world *world, uint32_t face,
                        struct corner4 corners[CORNERS])
{
    const struct tia_flat_scene *flat = world->flat;
    bool orthographic = flat->eye.projection == TIA_ORTHOGRAPHIC;
    double width = orthographic ? (double)(INT64_C(1) << flat->grid.fraction) : 1;
    double scale =
        sure_two_to(-flat->grid.fraction / 2) * sure_two_to(-(flat->grid.fraction - flat->grid.fraction / 2));
    struct tia_raster_vertex vertex[TIA_SIDES];
    int count = (int)tia_flat_corners(flat, face, vertex);

    for (int i = 0; i < count; i++) {
        int64_t at[3];
        tia_flat_affine(flat, &vertex[i], at);
        for (int k = 0; k < 3; k++)
            corners[i].v[k] = (double)at[k];
        corners[i].v[3] = tia_flat_is_direction(flat, &vertex[i]) ? 0 : 1;
    }
    count = clip_to_window(corners, count, orthographic ? 3 : 2, width * WIDER);
    for (int places = world->places; places; places -= places > 0 ? 1 : -1)
        scale *= places > 0 ? .5 : 2;
    for (int i = 0; i < count; i++) {
        const struct corner4 from = corners[i];
        for (int k = 0; k < 3; k++)
            corners[i].v[k] = ((double)world->m[k][0] * from.v[0] + (double)world->m[k][1] * from.v[1] +
                               (double)world->m[k][2] * from.v[2]) *
                                  scale -
                              (double)map->origin[k] * P2M(28) * from.v[3];
    }
    return count;
}

/* Turns corners into a view's axes. */
static void turn(const struct tia_map_view *view, struct corner4 corners[CORNERS], int count)
{
    for (int i = 0; i < count; i++) {
        const struct corner4 from = corners[i];
        for (int k = 0; k < 3; k++) {
            const int64_t *axis = view->axes[k];
            corners[i].v[k] =
                ((double)axis[0] * from.v[0] + (double)axis[1] * from.v[1] + (double)axis[2] * from.v[2]) * SURE_Q62;
        }
    }
}

static void include(struct region *r, double u, double v)
{
    r->low[0] = u < r->low[0] ? u : r->low[0];
    r->low[1] = v < r->low[1] ? v : r->low[1];
    r->high[0] = u > r->high[0] ? u : r->high[0];
    r->high[1] = v > r->high[1] ? v : r->high[1];
}

static double size_of(double a)
{
    return a < 0 ? -a : a;
}

/* Includes the part of a polygon in the view. */
static void include_part(const struct tia_map *map, const struct tia_map_view *view, struct corner4 corners[CORNERS],
                         int count, struct region *r)
{
    double density = (double)map->density * P2M(40), middle = (double)map->size / 2;
    double width = map->view_count > 1 ? WIDER : (middle + MARGIN) / density;
    int depth = map->parallel ? 3 : 2;

    turn(view, corners, count);
    count = clip_to_window(corners, count, depth, width);
    for (int i = 0; i < count; i++) {
        const double *c = corners[i].v;
        if (c[depth] <= NEARLY_AT * (size_of(c[0]) + size_of(c[1]) + size_of(c[2]) + c[3])) {
            include(r, 0, 0);
            include(r, map->size, map->size);
            return;
        }
        include(r, middle + density * (c[0] / c[depth]), middle - density * (c[1] / c[depth]));
    }
}

static int limited(double a, unsigned size)
{
    return a < 0 ? 0 : a > size ? (int)size : (int)a;
}

void tia_simd_map_drawn(struct tia_map *map, const struct tia_world *world, const tia_flat_light *light)
{
    const struct tia_flat_scene *flat = world->flat;
    struct region region[TIA_CUBE_VIEWS];

    for (unsigned i = 0; i < map->view_count; i++)
        region[i] = (struct region){{1e9, 1e9}, {-1e9, -1e9}};
    for (uint32_t face = 0; face < flat->face_count; face++) {
        struct corner4 corners[CORNERS], own[CORNERS];
        int count = tia_flat_is_turned(flat, face, light) ? visible_part(map, world, face, corners) : 0;
        for (unsigned i = 0; i < map->view_count && count; i++) {
            for (int k = 0; k < count; k++)
                own[k] = corners[k];
            include_part(map, &map->view[i], own, count, &region[i]);
        }
    }
    for (unsigned i = 0; i < map->view_count; i++) {
        const struct region *r = &region[i];
        int x = limited(r->low[0] - MARGIN, map->size), y = limited(r->low[1] - MARGIN, map->size);
        int x1 = limited(r->high[0] + MARGIN, map->size), y1 = limited(r->high[1] + MARGIN, map->size);
        map->view[i].drawn = (struct tia_tile){(uint16_t)x, (uint16_t)y, (uint16_t)(x1 > x ? x1 - x : 0),
                                               (uint16_t)(y1 > y ? y1 - y : 0)};
    }
}
