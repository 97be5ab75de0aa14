/* limit_cases.h - a scene, changes that bring it to each of its limits and one step beyond, and the faults that are
 * reported beyond. */
#ifndef TESTS_LIMIT_CASES_H
#define TESTS_LIMIT_CASES_H

#include <tia/scene.h>

#define ONE TIA_Q16_ONE
#define FAR "every point must be nearer to the eye than 32768"
#define UNIT "each channel must be in 0..1"
#define LENGTH "its length must be in 0.5..1.5"

/* An object in front of the eye, on a floor, lit. A case changes a part of the scene. */
static struct tia_scene scene;
static struct tia_material materials[2];
static struct tia_shape shapes[2];
static struct tia_sphere sphere;
static struct tia_light light;
static struct tia_transform transform;
static struct tia_texture texture;
static struct tia_grid grid;
static uint8_t texels[3 * TIA_TEXTURE_MAX], cells[TIA_GRID_MAX];

static struct tia_shape *const shape = &shapes[1];

static void set_up(void)
{
    const struct tia_material matt = {.colour = TIA_RGB(0.8, 0.6, 0.4), .exponent = ONE, .index = ONE};

    materials[0] = materials[1] = matt;
    shapes[0] = (struct tia_shape){.kind = TIA_PLANE, .plane = {TIA_VEC3(0, -2, 0), {0, TIA_Q30_ONE, 0}}};
    *shape = (struct tia_shape){.kind = TIA_SPHERE, .material = 1, .sphere = {TIA_VEC3(0, 0, -6), 2 * ONE}};
    light = (struct tia_light){.centre = TIA_VEC3(3, 5, -2), .emission = TIA_RGB(1, 1, 1)};
    transform = (struct tia_transform){{0, 0, 0}, {0, 0, 0}, {ONE, ONE, ONE}};
    texture = (struct tia_texture){.repeat = {ONE, ONE}, .offset = {INT32_MIN, INT32_MAX}, .cells[1] = matt.colour};
    texture.width = texture.height = 1, texture.texels = texels;
    grid = (struct tia_grid){TIA_VEC3(-1, -1, -6), ONE, {1, 1, 1}, cells};
    scene = (struct tia_scene){.camera = {.fov = 40 * ONE}, .materials = materials, .material_count = 2};
    scene.shapes = shapes;
    scene.shape_count = 2;
    scene.lights = &light;
    scene.light_count = 1;
    scene.transforms = &transform;
    scene.textures = &texture;
    scene.grids = &grid;
    scene.transform_count = scene.texture_count = scene.grid_count = 1;
}

/* Defines a function that changes the scene to a limit; or, if `beyond` is 1, to one step beyond it. */
#define LIMIT(name) static void name(int beyond)

LIMIT(narrowest_view)
{
    scene.camera.fov = TIA_FOV_MIN - beyond;
}

LIMIT(widest_view)
{
    scene.camera.fov = TIA_FOV_MAX + beyond;
}

LIMIT(most_samples)
{
    scene.camera.samples = TIA_SAMPLES_MAX + (uint32_t)beyond;
}

/* a coordinate k with 5 k = 2^31 - 3 */
#define FIFTH (INT32_MAX / 5)

LIMIT(farthest_window)
{
    scene.camera.projection = TIA_ORTHOGRAPHIC;
    scene.camera.window = (struct tia_window){-3 * FIFTH, 3 * FIFTH, -4 * FIFTH - 4 * beyond, 4 * FIFTH, 0};
    shape->sphere.centre.z = -8000 * ONE;
    shape->sphere.radius = 16000 * ONE;
    materials[1].facing = materials[1].colour;
}

LIMIT(nearest_window)
{
    scene.camera.projection = TIA_FRUSTUM;
    scene.camera.window = (struct tia_window){-1, 1, -1, 1, 1 - beyond};
}

LIMIT(farthest_reference)
{
    scene.camera.reference = (struct tia_vec3){0, -3 * FIFTH - 8 * beyond, -4 * FIFTH};
    scene.camera.up.y = ONE;
}

LIMIT(steepest_up)
{
    scene.camera.reference.z = -ONE;
    scene.camera.up = (struct tia_vec3){0, 1001 - 2 * beyond, 1024000};
}

LIMIT(deepest)
{
    const struct tia_rgb white = TIA_RGB(1, 1, 1);

    materials[0].mirror = materials[1].mirror = white;
    scene.depth = TIA_DEPTH_MAX + (uint32_t)beyond;
}

LIMIT(brightest_surface)
{
    materials[1].colour.r = materials[1].emission.g = materials[0].colour.b = TIA_Q30_ONE;
    materials[0].colour.b += beyond;
}

LIMIT(dullest)
{
    materials[1].specular = materials[1].colour;
    materials[1].exponent = ONE - beyond;
}

LIMIT(glossiest)
{
    materials[1].specular = materials[1].colour;
    materials[1].exponent = TIA_EXPONENT_MAX + beyond;
}

LIMIT(least_index)
{
    materials[1].refraction = materials[1].colour;
    materials[1].index = TIA_INDEX_MIN - beyond;
}

LIMIT(most_index)
{
    materials[1].refraction = materials[1].colour;
    materials[1].fresnel = true;
    materials[1].index = TIA_INDEX_MAX + beyond;
}

#include "limit_textures.h"

LIMIT(smallest_light)
{
    light.kind = TIA_SPHERE_LIGHT;
    light.radius = TIA_RADIUS_MIN - beyond;
}

LIMIT(most_light_samples)
{
    light.kind = TIA_DISC_LIGHT;
    light.radius = ONE;
    light.direction.y = -TIA_Q30_ONE;
    light.samples = (uint16_t)(TIA_LIGHT_SAMPLES_MAX + beyond);
}

LIMIT(dimmest_light)
{
    light.emission = (struct tia_rgb){0, INT32_MAX, -beyond};
}

LIMIT(narrowest_spot)
{
    light.kind = TIA_SPOT_LIGHT;
    light.centre = (struct tia_vec3)TIA_VEC3(0, 64, 74); /* the light reaches only the floor in front of the ball */
    light.direction = (struct tia_dir3){0, TIA_Q30(-0.6), TIA_Q30(-0.7)};
    light.outer = ONE - beyond;
}

LIMIT(widest_spot)
{
    light.kind = TIA_SPOT_LIGHT;
    light.direction.y = -TIA_Q30_ONE / 2 + beyond; /* the shortest direction */
    light.inner = light.outer = 90 * ONE;
}

LIMIT(wider_spot)
{
    light.kind = TIA_SPOT_LIGHT;
    light.direction.y = -TIA_Q30_ONE;
    light.outer = 90 * ONE + beyond;
}

LIMIT(longest_direction)
{
    light.kind = TIA_DIRECTIONAL_LIGHT;
    light.direction.y = -TIA_Q30_ONE / 2 * 3 - beyond;
}

/* At a distance of 2^-5 from the ball, the attenuation leaves 1/32. */
LIMIT(steepest_attenuation)
{
    light.quadratic = 32767 * ONE + beyond;
    light.centre = scene.camera.eye = (struct tia_vec3){0, 0, -4 * ONE + ONE / 32};
    light.emission = (struct tia_rgb){INT32_MAX, INT32_MAX, INT32_MAX};
}

LIMIT(slightest_attenuation)
{
    light.linear = 1;
    light.constant = -beyond;
}

LIMIT(farthest_light)
{
    light.centre = (struct tia_vec3){0, 4 * FIFTH + 4 * beyond, -3 * FIFTH};
}

LIMIT(smallest_sphere)
{
    shape->kind = TIA_GRID; /* the shape no longer hides the sphere */
    scene.spheres = &sphere;
    scene.sphere_count = 1;
    sphere = (struct tia_sphere){{0, 0, -200}, TIA_RADIUS_MIN - beyond, 1};
}

LIMIT(largest_sphere)
{
    shape->sphere.radius = 16000 * ONE;
    shape->sphere.centre.z = INT32_MIN + 1 + 16000 * ONE - beyond;
}

LIMIT(farthest_plane)
{
    shapes[0].plane.point = (struct tia_vec3){0, -3 * FIFTH - 8 * beyond, -4 * FIFTH};
    shapes[0].plane.normal.z = TIA_Q30_ONE / 2;
}

LIMIT(longest_normal)
{
    shapes[0].plane.normal.y = TIA_Q30_ONE / 2 * 3 + beyond;
}

LIMIT(smallest_disc)
{
    *shape = (struct tia_shape){.kind = TIA_DISC, .disc = {{0, 0, -200}, {0, 0, TIA_Q30_ONE}, TIA_RADIUS_MIN - beyond}};
}

LIMIT(shortest_cylinder)
{
    *shape = (struct tia_shape){.kind = TIA_CYLINDER,
                                .cylinder = {{0, 0, -5 * ONE}, {0, 0, -5 * ONE - 64 + beyond}, 2 * ONE, true}};
}

LIMIT(thinnest_cylinder)
{
    *shape = (struct tia_shape){.kind = TIA_CYLINDER,
                                .cylinder = {{-5, 0, -200}, {7 * ONE, 0, -400}, TIA_RADIUS_MIN - beyond, true}};
}

LIMIT(bluntest_cone)
{
    *shape = (struct tia_shape){.kind = TIA_CONE,
                                .cone = {TIA_VEC3(0, -1, -6), TIA_VEC3(0, 1, -6), ONE, ONE - 1 + beyond, true}};
}

LIMIT(thinnest_box)
{
    *shape = (struct tia_shape){.kind = TIA_BOX, .box = {TIA_VEC3(-1, -1, -6), TIA_VEC3(1, 1, -6)}};
    shape->box.max.z += 1 - beyond;
}

LIMIT(narrowest_triangle)
{
    shape->kind = TIA_TRIANGLE;
    shape->triangle = (struct tia_triangle){{TIA_VEC3(-2, -1, -6), TIA_VEC3(0, 0, -6), TIA_VEC3(2, 1, -6)}};
    shape->triangle.corner[1].x -= 1 - beyond;
}

LIMIT(smallest_scale)
{
    transform.position.z = -6 * ONE;
    transform.scale.x = transform.scale.y = transform.scale.z = TIA_SCALE_MIN;
    transform.scale.y -= beyond;
    *shape = (struct tia_shape){.kind = TIA_SPHERE, .transform = 1, .sphere = {{0, 0, 0}, 1000 * ONE}};
}

LIMIT(largest_scale)
{
    transform.position.z = -6 * ONE;
    transform.scale.x = transform.scale.y = transform.scale.z = TIA_SCALE_MAX;
    transform.scale.z += beyond;
    *shape = (struct tia_shape){.kind = TIA_CONE, .transform = 1, .cone = {{0, -100, 0}, {0, 100, 0}, 0, 99, true}};
}

/* The radius around the box, half its diagonal, is 1448 2^10 sqrt(2) units of 2^-16: just below 32, the limit for the
 * least scale 2^-10. */
LIMIT(flattest)
{
    transform.position = (struct tia_vec3)TIA_VEC3(0, 0, -60);
    transform.rotation.y = 30 * ONE;
    transform.scale.x = ONE / 1024;
    *shape = (struct tia_shape){.kind = TIA_BOX, .transform = 1};
    shape->box = (struct tia_box){{0, -1448 * 1024, -1448 * 1024}, {1, 1448 * 1024, 1448 * 1024}};
    shape->box.max.z += 1024 * beyond;
    shape->box.max.y += 1024 * beyond;
}

LIMIT(farthest_transform)
{
    transform.position = (struct tia_vec3){3 * FIFTH + 8 * beyond, 0, -4 * FIFTH};
    *shape =
        (struct tia_shape){.kind = TIA_SPHERE, .transform = 1, .sphere = {{-3 * FIFTH, 0, 4 * FIFTH - 6 * ONE}, ONE}};
}

LIMIT(longest_grid)
{
    *shape = (struct tia_shape){.kind = TIA_GRID};
    grid = (struct tia_grid){{-512 * 64, -100, -6 * ONE}, 64 - 0, {(uint16_t)(TIA_GRID_MAX + beyond), 1, 1}, cells};
}

LIMIT(smallest_cell)
{
    *shape = (struct tia_shape){.kind = TIA_GRID};
    grid = (struct tia_grid){{-128, -100, -300}, TIA_RADIUS_MIN - beyond, {4, 1, 1}, cells};
}

LIMIT(farthest_cell)
{
    *shape = (struct tia_shape){.kind = TIA_GRID};
    scene.camera.eye.x = 32760 * ONE;
    grid = (struct tia_grid){{INT32_MAX - 4 * ONE + beyond, -ONE, -9 * ONE}, ONE, {4, 2, 1}, cells};
}

static const struct {
    void (*set)(int beyond);
    const char *name, *thing;
    uint32_t index;
    const char *field, *rule;
} limits[] = {
#define ROW(name, ...)                                                                                                 \
    {                                                                                                                  \
        name, #name, __VA_ARGS__                                                                                       \
    }
    ROW(narrowest_view, "camera", 0, "fov", "must be in 1..170 degrees"),
    ROW(widest_view, "camera", 0, "fov", "must be in 1..170 degrees"),
    ROW(most_samples, "camera", 0, "samples", "must be 1, 4 or 16"),
    ROW(farthest_window, "camera", 0, "window", FAR),
    ROW(nearest_window, "camera", 0, "window", "near must be above 0"),
    ROW(farthest_reference, "camera", 0, "reference", FAR),
    ROW(steepest_up, "camera", 0, "up", "must be at least 0.056 degrees off the line of sight"),
    ROW(deepest, "scene", 0, "depth", "must be in 1..16"),
    ROW(brightest_surface, "material", 0, "colour", UNIT),
    ROW(dullest, "material", 1, "exponent", "must be in 1..10000"),
    ROW(glossiest, "material", 1, "exponent", "must be in 1..10000"),
    ROW(least_index, "material", 1, "index", "must be in 0.25..4"),
    ROW(most_index, "material", 1, "index", "must be in 0.25..4"),
    ROW(fewest_repeats, "texture", 0, "repeat", "must be 1/1024 or more"),
    ROW(least_repeat_bits, "texture", 0, "repeat_bits", "must be in -8..12"),
    ROW(most_repeat_bits, "texture", 0, "repeat_bits", "must be in -8..12"),
    ROW(least_offset_bits, "texture", 0, "offset_bits", "must be in -8..12"),
    ROW(most_offset_bits, "texture", 0, "offset_bits", "must be in -8..12"),
    ROW(widest_image, "texture", 0, "width", "must be in 1..16384"),
    ROW(highest_image, "texture", 0, "height", "must be in 1..16384"),
    ROW(smallest_light, "light", 0, "radius", "must be 0 or at least 2^-10"),
    ROW(most_light_samples, "light", 0, "samples", "must be in 1..256"),
    ROW(dimmest_light, "light", 0, "emission", "each channel must be in 0..2"),
    ROW(narrowest_spot, "light", 0, "outer", "must be in 1..90 degrees"),
    ROW(widest_spot, "light", 0, "direction", LENGTH),
    ROW(wider_spot, "light", 0, "outer", "must be in 1..90 degrees"),
    ROW(longest_direction, "light", 0, "direction", LENGTH),
    ROW(steepest_attenuation, "light", 0, "attenuation", "each term must be in 0..32767"),
    ROW(slightest_attenuation, "light", 0, "attenuation", "each term must be in 0..32767"),
    ROW(farthest_light, "light", 0, "centre", FAR),
    ROW(smallest_sphere, "sphere", 0, "radius", "must be at least 2^-10"),
    ROW(largest_sphere, "shape", 1, "centre", FAR),
    ROW(farthest_plane, "shape", 0, "point", FAR),
    ROW(longest_normal, "shape", 0, "normal", LENGTH),
    ROW(smallest_disc, "shape", 1, "radius", "must be at least 2^-10"),
    ROW(shortest_cylinder, "shape", 1, "top", "must be at least 2^-10 from the base"),
    ROW(thinnest_cylinder, "shape", 1, "radius", "must be at least 2^-10"),
    ROW(bluntest_cone, "shape", 1, "top_radius", "must differ from the base's"),
    ROW(thinnest_box, "shape", 1, "max", "must be above min"),
    ROW(narrowest_triangle, "shape", 1, "corners", "must not be on one line"),
    ROW(smallest_scale, "transform", 0, "scale", "must be in 2^-10..1024"),
    ROW(largest_scale, "transform", 0, "scale", "must be in 2^-10..1024"),
    ROW(flattest, "shape", 1, "transform",
        "too flat for its size: the radius around it, over the least scale, must be below 32768"),
    ROW(farthest_transform, "transform", 0, "position", FAR),
    ROW(longest_grid, "grid", 0, "size", "must be in 1..1024"),
    ROW(smallest_cell, "grid", 0, "cell", "must be at least 2^-10"),
    ROW(farthest_cell, "grid", 0, "cell", "all cells must end below 32768"),
};

#endif
