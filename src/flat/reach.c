/* reach.c - the ranges of corners and lights.
 *
 * Let the width and height be at most 2^b pixels: half a pixel is then at least 2^-b of half the window. Let corners
 * have coordinates below R = 2^r, and let the light have a coordinate of 2^(d-1) or more, where d is the range of
 * corners and light together.
 *
 * A light that is a vertex of range d is rounded by at most 2^-(30 - d), and so are all corners then, since
 * orthographic vertices have 29 - d fraction bits.
 *
 * Now let a light l be replaced by the direction from the eye to it. A point p casts its shadow at p + s (p - l), and s
 * < 2R/(2^(d-1) - R), since the shadow is less than 2R from the point along each axis. With the direction, the shadow
 * is at p - s l. The difference is s p, which is less than 2^(2r + 2 - d) if R is small compared with 2^d. This is
 * below half a pixel if d >= 2r + 2 + b, and no more than the rounding if d >= r + 16. */
#include "reach.h"

#include <tia/debug.h>

#include "math/integer.h"
#include "source.h"

#define POINT_BITS(flat) ((flat) ? 29 : 40) /* bits of a coordinate, see raster.h */

/* ROOM_RANGE is the range up to which lights may move while the vertices stay valid. Vertices then have at least 20
 * fraction bits, or 9 in orthographic views, where lights may move at most to 2^NEAR_BITS times the faces' reach. */
#define ROOM_RANGE 20
#define NEAR_BITS 9

/* ---- corners ---- */

static unsigned larger(unsigned a, unsigned b)
{
    return a > b ? a : b;
}

static unsigned smaller(unsigned a, unsigned b)
{
    return a < b ? a : b;
}

static unsigned range_of_object(const struct tia_scene *scene, const struct tia_eye *eye, uint32_t object,
                                struct cancel *cancel)
{
    struct tia_flat_source source;
    unsigned most = 0;

    if (!tia_flat_takes(scene, object))
        return 0;
    tia_flat_source_init(&source, scene, object);
    for (uint32_t i = 0; i < tia_flat_places(&source) && !cancelled(cancel, 1); i++) {
        int64_t world[3];
        tia_flat_source_point(&source, i, world);
        most = larger(most, tia_eye_range(eye, world));
    }
    return most;
}

unsigned tia_reach_of_faces(const struct tia_scene *scene, const struct tia_eye *eye, struct cancel *cancel)
{
    unsigned most = 0;

    for (uint32_t s = 0; s < scene->sphere_count + scene->shape_count; s++)
        most = larger(most, range_of_object(scene, eye, s, cancel));
    return most;
}

static bool is_view(const struct tia_scene *scene, unsigned width, unsigned height)
{
    return width && height && width <= TIA_SIZE_MAX && height <= TIA_SIZE_MAX && !tia_scene_check(scene, NULL);
}

uint32_t tia_shadow_too_far(const struct tia_scene *scene, unsigned width, unsigned height)
{
    struct cancel cancel = {.stop = NULL};
    struct tia_eye eye;

    if (!is_view(scene, width, height))
        return TIA_NO_OBJECT;
    tia_eye_init(&eye, scene, width, height);
    for (uint32_t s = 0; scene->shadows && s < scene->sphere_count + scene->shape_count; s++)
        if (range_of_object(scene, &eye, s, &cancel) > tia_reach_most(eye.projection))
            return s;
    return TIA_NO_OBJECT;
}

/* ---- lights ---- */

static bool has_place(const struct tia_light *light)
{
    return !tia_light_has(light->kind, TIA_LIGHT_PLACELESS);
}

static bool is_flat(const struct tia_reach *reach)
{
    return reach->eye->projection == TIA_ORTHOGRAPHIC;
}

/* Returns the b of the derivation: the image is at most 2^b pixels wide and high. */
static unsigned image_bits(const struct tia_reach *reach)
{
    return 32 - (unsigned)tia_clz32((larger(reach->width, reach->height) - 1) | 1);
}

/* Returns the range of a light: the largest range of eight corners around its rectangle or disc. For a point light all
 * eight coincide. */
static unsigned range_of_light(const struct tia_eye *eye, const struct tia_light *light)
{
    const int64_t centre[3] = {light->centre.x, light->centre.y, light->centre.z};
    const int64_t a[3] = {light->side[0].x, light->side[0].y, light->side[0].z};
    const int64_t b[3] = {light->side[1].x, light->side[1].y, light->side[1].z};
    unsigned most = 0;

    for (int i = 0; i < 8; i++) {
        const int64_t s[3] = {i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1};
        int64_t at[3];
        for (int k = 0; k < 3; k++)
            at[k] = (centre[k] + (tia_light_has(light->kind, TIA_LIGHT_SIDES)  ? s[0] * a[k] + s[1] * b[k]
                                  : tia_light_has(light->kind, TIA_LIGHT_DISC) ? s[k] * light->radius
                                                                               : 0)) *
                    65536;
        most = larger(most, tia_eye_range(eye, at));
    }
    return most;
}

static bool is_far(const struct tia_reach *reach, unsigned range)
{
    return is_flat(reach) && range >= larger(2 * reach->faces + 2 + image_bits(reach), reach->faces + 16);
}

bool tia_reach_is_direction(const struct tia_reach *reach, const struct tia_light *light)
{
    return tia_light_has(light->kind, TIA_LIGHT_FAR) ||
           (has_place(light) && is_far(reach, range_of_light(reach->eye, light)));
}

unsigned tia_reach_of_lights(const struct tia_reach *reach)
{
    unsigned most = tia_reach_most(reach->eye->projection);

    return is_flat(reach) ? larger(reach->faces, smaller(most, 30 - image_bits(reach))) : most;
}

/* Gives a light's range; false: the light is ambient, or counts as a direction. */
static bool find_range(const struct tia_reach *reach, const struct tia_light *light, unsigned *range)
{
    if (!has_place(light))
        return false;
    *range = range_of_light(reach->eye, light);
    return !is_far(reach, *range);
}

uint32_t tia_reach_too_far(const struct tia_reach *reach, const struct tia_light *lights, uint32_t count)
{
    unsigned most = tia_reach_of_lights(reach), range;

    for (uint32_t i = 0; i < count; i++)
        if (find_range(reach, &lights[i], &range) && range > most)
            return i;
    return count;
}

uint32_t tia_shadow_light_too_far(const struct tia_scene *scene, const struct tia_light *lights, uint32_t count,
                                  unsigned width, unsigned height, unsigned *range)
{
    struct cancel cancel = {.stop = NULL};
    struct tia_reach reach = {.width = width, .height = height};
    struct tia_eye eye;

    if (!is_view(scene, width, height) || !scene->shadows || (count && !lights) || !range)
        return TIA_NO_OBJECT;
    tia_eye_init(&eye, scene, width, height);
    reach.eye = &eye;
    reach.faces = tia_reach_of_faces(scene, &eye, &cancel);
    uint32_t light = tia_reach_too_far(&reach, lights, count);
    *range = tia_reach_of_lights(&reach);
    return light < count ? light : TIA_NO_OBJECT;
}

/* ---- faces with lights ---- */

static unsigned range_of_places(const struct tia_reach *reach, const struct tia_light *lights, uint32_t count)
{
    unsigned most = reach->faces, range;

    for (uint32_t i = 0; i < count; i++)
        if (find_range(reach, &lights[i], &range))
            most = larger(most, range);
    return most;
}

/* Returns the largest range of a light's point that still fits a coordinate with the fraction bits for `range`. */
static unsigned limit_of(const struct tia_reach *reach, unsigned range)
{
    struct tia_raster_grid grid;
    int status =
        tia_raster_grid_init(&grid, reach->eye->projection, reach->width, reach->height, reach->samples, 0, range);

    return status ? 0 : (unsigned)(POINT_BITS(is_flat(reach)) - grid.fraction);
}

/* Returns the range of the scene's lights in all states that keys set, with a margin: each light may move to four times
 * its distance, but at most to 2^ROOM_RANGE, in orthographic views also at most to 2^NEAR_BITS times the reach of the
 * faces. */
static unsigned with_room(const struct tia_reach *reach, const struct tia_scene *scene)
{
    unsigned room = is_flat(reach) ? smaller(reach->faces + NEAR_BITS, ROOM_RANGE) : ROOM_RANGE;
    unsigned most = reach->faces, range;

    for (uint32_t i = 0; i < scene->light_count + scene->binding_count; i++) {
        const struct tia_light *light =
            i < scene->light_count ? &scene->lights[i] : &scene->bindings[i - scene->light_count].state;
        if (find_range(reach, light, &range) && range <= tia_reach_of_lights(reach))
            most = larger(most, larger(range, smaller(range + 2, room)));
    }
    return most;
}

unsigned tia_reach_with_lights(const struct tia_reach *reach, const struct tia_scene *scene,
                               const struct tia_light *lights, uint32_t count)
{
    unsigned places = range_of_places(reach, lights, count), range = reach->faces;

    if (is_flat(reach) || limit_of(reach, range) <= range)
        range = with_room(reach, scene);
    return places <= limit_of(reach, range) ? range : places;
}
