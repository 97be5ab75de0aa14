/* map_view.c - the views of a light's map, and the position of points in them. */
#include "map.h"

#include "math/trig.h"
#include "math/wide.h"
#include "scene/axes.h"

#define ONE (INT64_C(1) << 62)
#define DENSITY_BITS 40
#define LEAST_HALF (INT64_C(1) << (TIA_WORLD_BITS - 8)) /* least half width of a view, for a scene without extent */

unsigned tia_map_views(const struct tia_light *light)
{
    bool narrow = tia_light_has(light->kind, TIA_LIGHT_CONE) && light->outer <= TIA_Q16(TIA_SPOT_MAP);

    return narrow || tia_light_has(light->kind, TIA_LIGHT_FAR) ? 1 : TIA_CUBE_VIEWS;
}

/* ---- axes ---- */

static void along_world(int64_t axes[3][3], unsigned view)
{
    int forward = (int)view / 2;

    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            axes[i][k] = 0;
    axes[0][(forward + 1) % 3] = axes[1][(forward + 2) % 3] = ONE;
    axes[2][forward] = view % 2 ? -ONE : ONE;
}

/* Gives axes for a view that looks along `forward`. */
static void along_direction(int64_t axes[3][3], const int64_t forward[3])
{
    int64_t aside[3] = {0, 0, 0}, across[3];
    int least = 0;

    for (int k = 1; k < 3; k++)
        if ((forward[k] < 0 ? -forward[k] : forward[k]) < (forward[least] < 0 ? -forward[least] : forward[least]))
            least = k;
    aside[least] = ONE / 2;
    tia_axes_cross(forward, aside, across);
    (void)wide_normalise(across, axes[0]);
    tia_axes_cross(axes[0], forward, axes[1]);
    for (int k = 0; k < 3; k++)
        axes[2][k] = forward[k];
}

static int64_t dot(const int64_t axis[3], const int64_t place[3])
{
    return wide_round(wide_dot(axis, place), 62);
}

/* ---- from the scene's coordinates to a view's ---- */

/* Returns a row of a view's matrix for vertices; in the world's coordinates it is axis times scale 2^-scale_places. */
static struct tia_eye_row row_of(const struct tia_world *world, const int64_t axis[3], int64_t scale, int scale_places)
{
    int shift = 0, spread = 8 + world->flat->grid.fraction - 32; /* for a row applied to 256 times a coordinate, in
                                                                    Q.32 */
    struct tia_eye_row row = {.offset = 0};
    wide product[3];

    for (int k = 0; k < 3; k++) {
        const int64_t column[3] = {world->m[0][k], world->m[1][k], world->m[2][k]};
        product[k] = wide_product(dot(axis, column), scale);
        int bits = wide_bits(wide_size(product[k]));
        shift = bits - 61 > shift ? bits - 61 : shift;
    }
    for (int k = 0; k < 3; k++)
        row.m[k] = shift ? wide_round(product[k], (unsigned)shift) : (int64_t)wide_low(product[k]);
    row.places = world->places + scale_places - shift + spread;
    return row;
}

static int bits_of(unsigned size)
{
    return 31 - (int)tia_clz32(size);
}

static void make_rows(struct tia_map *map, const struct tia_world *world, struct tia_map_view *view)
{
    int zoom_places = DENSITY_BITS + bits_of(map->size) - 1; /* fraction bits of the density times 2/size */
    const int64_t back[3] = {-view->axes[2][0], -view->axes[2][1], -view->axes[2][2]};

    for (int k = 0; k < 2; k++)
        view->eye.row[k] = row_of(world, view->axes[k], map->density, zoom_places);
    view->eye.row[2] = row_of(world, map->parallel ? back : view->axes[2], INT64_C(1) << 60, 60);
    view->eye.projection = map->parallel ? TIA_ORTHOGRAPHIC : TIA_PERSPECTIVE;
    if (!map->parallel)
        return;
    for (int k = 0; k < 2; k++) {
        wide middle = wide_product(-dot(view->axes[k], map->origin), map->density);
        view->eye.row[k].offset = wide_round(middle, (unsigned)(TIA_WORLD_BITS + zoom_places - 32));
        view->eye.row[k].offset_places = 32;
    }
    view->eye.row[2].offset = dot(view->axes[2], map->origin);
    view->eye.row[2].offset_places = TIA_WORLD_BITS;
}

/* Gives 256 times the affine coordinates of a vertex. */
static void spread(const struct tia_flat_scene *flat, const struct tia_raster_vertex *v, int64_t out[3])
{
    tia_flat_affine(flat, v, out);
    for (int k = 0; k < 3; k++)
        out[k] *= 256;
}

/* Prepares the views' grids. Vertices must be below 2^20; larger scenes have a larger unit. */
static int make_lattice(struct tia_map *map, const struct tia_flat_scene *flat)
{
    unsigned range = 0;
    int status = TIA_OK;

    for (unsigned i = 0; i < map->view_count; i++)
        for (uint32_t n = 0; n < flat->point_count; n++) {
            int64_t at[3];
            spread(flat, &flat->points[n], at);
            unsigned own = tia_flat_is_direction(flat, &flat->points[n]) ? 0 : tia_eye_range(&map->view[i].eye, at);
            range = own > range ? own : range;
        }
    map->unit = range > 20 ? (int)range - 20 : 0;
    map->coarse = range > 3 ? (int)range - 3 : 0;
    for (unsigned i = 0; i < map->view_count; i++) {
        struct tia_map_view *view = &map->view[i];
        for (int k = 0; k < 3; k++) {
            view->eye.row[k].places += map->unit;
            view->eye.row[k].offset_places += map->unit;
        }
        status = status ? status
                        : tia_raster_grid_init(&view->grid, view->eye.projection, map->size, map->size, 1, 0,
                                               range - (unsigned)map->unit);
    }
    map->bits = map->view[0].grid.fraction + (int)range - map->unit;
    return status;
}

/* ---- the extent of views ---- */

/* Fits the view of parallel rays to all points. The origin is in the middle of the side of their box that faces the
 * light. */
static void fit(struct tia_map *map, const struct tia_world *world, int64_t texels)
{
    const struct tia_flat_scene *flat = world->flat;
    int64_t low[3] = {INT64_MAX, INT64_MAX, INT64_MAX}, high[3] = {INT64_MIN, INT64_MIN, INT64_MIN};
    int64_t half = LEAST_HALF, middle[3];
    const int64_t(*axes)[3] = (const int64_t(*)[3])map->view[0].axes;

    for (uint32_t n = 0; n < flat->point_count; n++) {
        int64_t place[3];
        if (tia_flat_is_direction(flat, &flat->points[n]))
            continue;
        tia_world_place(world, &flat->points[n], place);
        for (int k = 0; k < 3; k++) {
            int64_t at = dot(axes[k], place);
            low[k] = at < low[k] ? at : low[k];
            high[k] = at > high[k] ? at : high[k];
        }
    }
    for (int k = 0; k < 3; k++) {
        if (low[k] > high[k])
            low[k] = high[k] = 0;
        middle[k] = k < 2 ? low[k] + (high[k] - low[k]) / 2 : low[k];
        half = k < 2 && (high[k] - low[k] + 1) / 2 > half ? (high[k] - low[k] + 1) / 2 : half;
    }
    for (int i = 0; i < 3; i++) {
        const int64_t across[3] = {axes[0][i], axes[1][i], axes[2][i]};
        map->origin[i] = dot(across, middle);
    }
    map->density = wide_quotient(texels, half, DENSITY_BITS + TIA_WORLD_BITS);
}

static void aim(struct tia_map *map, const struct tia_world *world, const struct tia_map_light *from, int64_t texels)
{
    const struct tia_dir3 *d = &from->light->direction;
    int64_t forward[3] = {d->x, d->y, d->z}, unit[3];

    if (map->parallel) {
        tia_world_direction(world, &from->at, forward);
        for (int k = 0; k < 3; k++)
            unit[k] = -forward[k];
        along_direction(map->view[0].axes, unit);
        fit(map, world, texels);
        return;
    }
    tia_world_place(world, &from->at, map->origin);
    map->density = texels << DENSITY_BITS;
    if (map->view_count == 1) {
        (void)wide_normalise(forward, unit);
        along_direction(map->view[0].axes, unit);
        map->density = (int64_t)(tia_cotangent(2 * from->light->outer) >> (56 - DENSITY_BITS)) * texels;
        return;
    }
    for (unsigned i = 0; i < map->view_count; i++)
        along_world(map->view[i].axes, i);
}

int tia_map_init(struct tia_map *map, const struct tia_world *world, const struct tia_map_light *light, unsigned size,
                 unsigned border)
{
    map->parallel = tia_flat_is_direction(world->flat, &light->at);
    map->view_count = map->parallel ? 1 : tia_map_views(light->light);
    map->size = size;
    aim(map, world, light, (int64_t)size / 2 - border);
    for (unsigned i = 0; i < map->view_count; i++) {
        map->view[i].drawn = (struct tia_tile){0, 0, (uint16_t)size, (uint16_t)size};
        make_rows(map, world, &map->view[i]);
        for (int k = 0; k < 3; k++)
            map->view[i].eye.origin[k] = 0;
        if (!map->parallel)
            spread(world->flat, &light->at, map->view[i].eye.origin);
    }
    return make_lattice(map, world->flat);
}

/* ---- a point's position ---- */

static const struct tia_map_view *facing(const struct tia_map *map, const int64_t d[3])
{
    int most = 0;

    if (map->view_count == 1)
        return &map->view[0];
    for (int k = 1; k < 3; k++)
        if ((d[k] < 0 ? -d[k] : d[k]) > (d[most] < 0 ? -d[most] : d[most]))
            most = k;
    return &map->view[2 * most + (d[most] < 0)];
}

/* Returns the distance from the middle of the view along an axis, in texels, Q.16. */
static int64_t across(const struct tia_map *map, int64_t at, int64_t distance)
{
    int64_t tangent = map->parallel  ? at
                      : distance > 0 ? wide_quotient(at, distance, TIA_WORLD_BITS)
                                     : INT64_C(1) << 62;
    wide product = wide_product(tangent, map->density);
    const unsigned places = TIA_WORLD_BITS + DENSITY_BITS - 16;

    if (wide_bits(wide_size(product)) > (int)places + 40)
        return wide_is_negative(product) ? -(INT64_C(1) << 40) : INT64_C(1) << 40;
    return wide_round(product, places);
}

void tia_map_find(const struct tia_map *map, const int64_t place[3], struct tia_map_spot *spot)
{
    const int64_t d[3] = {place[0] - map->origin[0], place[1] - map->origin[1], place[2] - map->origin[2]};
    const struct tia_map_view *view = facing(map, d);
    int64_t middle = (int64_t)map->size << 15;

    spot->view = view;
    spot->distance = dot(view->axes[2], d);
    spot->u = middle + across(map, dot(view->axes[0], d), spot->distance);
    spot->v = middle - across(map, dot(view->axes[1], d), spot->distance);
    spot->texel = map->parallel ? wide_quotient(1, map->density, DENSITY_BITS + TIA_WORLD_BITS)
                                : wide_quotient(spot->distance, map->density, DENSITY_BITS);
}
