#include "map_look.h"

#include "math/wide.h"
#include "raster/depth.h"
#include "scene/axes.h"

#define STEEP (INT64_C(50) << 16) /* largest tangent, Q.16 */

void tia_map_look_init(struct tia_map_look *look, const struct tia_scene *scene)
{
    const struct tia_shadow_map *map = &scene->shadow_map;

    look->size = map->size ? map->size : TIA_MAP_SIZE_DEFAULT;
    look->bias = map->bias;
    look->amount = map->amount;
    if (map->bias == TIA_BIAS_DEFAULT) {
        look->bias = TIA_BIAS_SLOPE;
        look->amount = TIA_SHADOW_AMOUNT_DEFAULT;
    }
    if (look->bias == TIA_BIAS_CONSTANT)
        look->amount = tia_round_shift(look->amount * (INT64_C(1) << (TIA_WORLD_BITS - 16 + TIA_SCALE_BITS_MAX)),
                                       (unsigned)(TIA_SCALE_BITS_MAX - scene->scale_bits + map->amount_bits));
    look->filter = map->filter == TIA_FILTER_DEFAULT ? TIA_FILTER_3X3 : map->filter;
}

void tia_map_face(struct tia_map_point *point, const tia_flat_light *light, uint32_t face)
{
    const struct tia_flat_scene *flat = point->world->flat;
    struct tia_raster_vertex corners[TIA_SIDES];
    int64_t sides[2][3], normal[3];
    bool turned = tia_flat_side(flat, &flat->faces[face], light) < 0;

    point->face = face;
    point->of = NULL;
    (void)tia_flat_corners(flat, face, corners);
    for (int k = 0; k < 2; k++)
        if (tia_flat_is_direction(flat, &corners[k + 1]))
            tia_world_direction(point->world, &corners[k + 1], sides[k]);
        else
            tia_world_from_to(point->world, &corners[0], &corners[k + 1], sides[k]);
    tia_axes_cross(sides[turned], sides[!turned], normal);
    (void)wide_normalise(normal, point->normal);
}

/* Returns the tangent of the angle between the normal and the direction to the light, Q.16. */
static int64_t tangent(const struct tia_map_point *point, const int64_t place[3])
{
    const struct tia_map *map = point->map;
    int64_t way[3], unit[3];

    for (int k = 0; k < 3; k++)
        way[k] = map->parallel ? -map->view[0].axes[2][k] / 2 : map->origin[k] - place[k];
    (void)wide_normalise(way, unit);
    int64_t c = wide_round(wide_dot(unit, point->normal), 62);
    if (c <= 0)
        return STEEP;
    wide square = wide_difference(wide_up(wide_product(1, 1), 124), wide_product(c, c));
    int64_t t = wide_is_negative(square) ? 0 : wide_quotient(wide_sqrt(square), c, 16);
    return t < STEEP ? t : STEEP;
}

static void move(struct tia_map_point *point, const int64_t place[3], int64_t by)
{
    int64_t moved[3];

    for (int k = 0; k < 3; k++)
        moved[k] = place[k] + wide_round(wide_product(point->normal[k], by), 62);
    tia_map_find(point->map, moved, &point->spot);
}

/* Sets the face's plane in the point's view. The polygon is enlarged, since the face may cover no texel's middle, or
 * end just beside the view. */
static void find_plane(struct tia_map_point *point)
{
    const struct tia_map_view *view = point->spot.view;
    struct tia_raster_vertex corners[TIA_SIDES];
    struct tia_raster_plane plane = {.det = {0, 0}};
    struct tia_tile all = {0, 0, view->grid.width, view->grid.height};
    struct polygon polygon;

    if (point->of == view)
        return;
    unsigned sides = tia_map_corners(point->map, view, point->world->flat, point->face, corners);
    if (!tia_polygon_init_enlarged(&polygon, &view->grid, all, corners, sides) && polygon.count)
        tia_depth_plane(&polygon, &plane);
    tia_map_plane_init(&point->plane, point->map, view, &plane);
    point->of = view;
}

void tia_map_place(struct tia_map_point *point, const struct tia_map_look *look, const int64_t place[3])
{
    tia_map_find(point->map, place, &point->spot);
    int64_t bias = look->bias == TIA_BIAS_CONSTANT ? look->amount
                   : look->bias == TIA_BIAS_NONE   ? 0
                                                   : wide_round(wide_product(look->amount, point->spot.texel), 16);
    if (look->bias == TIA_BIAS_NORMAL) {
        move(point, place, bias);
        bias = 0;
    }
    if (look->bias == TIA_BIAS_SLOPE)
        bias = wide_round(wide_product(bias, TIA_Q16_ONE + tangent(point, place)), 16);
    point->limit = point->spot.distance - bias;
    point->slack = bias;
    if (look->bias == TIA_BIAS_PLANE)
        find_plane(point);
}

static int64_t within(int64_t i, unsigned size)
{
    return i < 0 ? 0 : i < size ? i : size - 1;
}

static uint32_t texel(const struct tia_map_point *point, int64_t i, int64_t j)
{
    unsigned size = point->map->size;

    if (point->map->view_count == 1 && (i < 0 || j < 0 || i >= size || j >= size))
        return TIA_MAP_NOTHING;
    return point->spot.view->distance[(size_t)within(j, size) * size + (size_t)within(i, size)];
}

int64_t tia_map_read(const struct tia_map_point *point, int64_t i, int64_t j)
{
    return (int64_t)texel(point, i, j) << point->map->coarse;
}

/* Returns the smallest distance at a texel that does not shadow the point. The plane is rounded as the map's faces are,
 * so that without slack the face itself is exactly at the limit. */
static int64_t limit_at(const struct tia_map_point *point, int64_t i, int64_t j)
{
    const struct tia_map *map = point->map;

    if (!point->of)
        return point->limit;
    uint32_t here = tia_map_distance(map, &point->plane, (int)within(i, map->size), (int)within(j, map->size));
    return here ? ((int64_t)here << map->coarse) - point->slack : point->limit;
}

uint32_t tia_map_least(const struct tia_map *map, int64_t limit)
{
    int64_t least = limit > 0 ? ((limit - 1) >> map->coarse) + 1 : 0;

    return least < TIA_MAP_FAR ? (uint32_t)least : TIA_MAP_FAR;
}

bool tia_map_tap(const struct tia_map_point *point, int64_t i, int64_t j)
{
    return texel(point, i, j) >= tia_map_least(point->map, limit_at(point, i, j));
}
