#include "corpus_rays.h"

#include <string.h>

#include "corpus_parts.h"
#include "dice.h"

#define ZERO TIA_VEC3(0, 0, 0)

/* Bounds of the objects' centres. The eye is at least 8 away from their vertical axis. */
#define LOW ((struct tia_vec3)TIA_VEC3(-3.5, 0.2, -3.5))
#define HIGH ((struct tia_vec3)TIA_VEC3(3.5, 3.5, 3.5))

/* Chooses a small size, since a pixel can take a thousand rays. */
static void random_size(uint64_t *state, struct corpus_rays *out)
{
    static const uint16_t sizes[][2] = {{120, 90},  {160, 120}, {160, 120}, {163, 117}, {200, 150}, {200, 150},
                                        {240, 135}, {120, 160}, {320, 240}, {321, 243}, {400, 300}, {640, 480}};
    bool slow = out->scene.camera.samples > 1;
    uint64_t i = dice_next(state) % (slow ? 4 : sizeof sizes / sizeof sizes[0]);

    out->width = sizes[i][0];
    out->height = sizes[i][1];
}

/* Chooses a window around the line of sight, not always centred. */
static void random_window(uint64_t *state, struct tia_camera *camera)
{
    bool wide = camera->projection == TIA_ORTHOGRAPHIC;
    tia_q16 half = wide ? dice_between(state, TIA_Q16(2), TIA_Q16(7)) : dice_between(state, TIA_Q16(0.2), TIA_Q16(0.7));

    camera->window.near = dice_between(state, TIA_Q16(0.8), TIA_Q16(1.2));
    camera->window.bottom = -half + dice_between(state, 0, half / 2);
    camera->window.top = half;
    if (dice_one_in(state, 2)) {
        camera->window.left = -half - dice_between(state, 0, half / 2);
        camera->window.right = half;
    }
}

/* Chooses a camera that looks along -z, or from any side at a point near the middle of the scene. */
static void random_camera(uint64_t *state, struct tia_camera *camera)
{
    static const uint8_t samples[] = {0, 1, 0, 1, 0, 1, 0, 4, 4, 16};
    static const struct tia_vec3 before[2] = {TIA_VEC3(-2, 0.7, 8), TIA_VEC3(2, 4, 18)};
    static const struct tia_vec3 near_middle[2] = {TIA_VEC3(-1, 0.5, -1), TIA_VEC3(1, 2, 1)};
    static const struct tia_vec3 upwards[2] = {TIA_VEC3(-0.2, 0.8, -0.2), TIA_VEC3(0.2, 1.2, 0.2)};

    camera->fov = dice_between(state, TIA_Q16(20), TIA_Q16(60));
    camera->projection = (enum tia_projection)(dice_one_in(state, 2) ? 0 : dice_next(state) % 3);
    camera->samples = samples[dice_next(state) % sizeof samples];
    camera->eye = dice_vec3(state, before[0], before[1]);
    if (!dice_one_in(state, 3)) {
        if (dice_one_in(state, 2))
            camera->eye.x = camera->eye.z / (dice_one_in(state, 2) ? 1 : -1);
        if (dice_one_in(state, 2))
            camera->eye.z = -camera->eye.z;
        camera->eye.y = dice_between(state, TIA_Q16(0.3), TIA_Q16(10));
        camera->reference = dice_vec3(state, near_middle[0], near_middle[1]);
        camera->up = dice_vec3(state, upwards[0], upwards[1]);
    }
    if (camera->projection != TIA_PERSPECTIVE)
        random_window(state, camera);
}

/* Makes a sphere, disc, cylinder or cone about `size` large around `centre`. */
static void random_round(uint64_t *state, struct tia_shape *shape, struct tia_vec3 centre, tia_q16 size)
{
    struct tia_vec3 top = centre;

    top.x += dice_between(state, -size, size);
    top.y += dice_between(state, size / 2, 2 * size);
    top.z += dice_between(state, -size, size);
    if (shape->kind == TIA_CYLINDER) {
        shape->cylinder.base = centre;
        shape->cylinder.top = top;
        shape->cylinder.radius = size / 2;
        shape->cylinder.capped = !dice_one_in(state, 3);
    } else {
        shape->cone.base = centre;
        shape->cone.top = top;
        shape->cone.base_radius = size;
        shape->cone.top_radius = dice_one_in(state, 2) ? 0 : dice_between(state, size / 4, size - 1);
        shape->cone.capped = !dice_one_in(state, 3);
    }
}

static void random_flat(uint64_t *state, struct tia_shape *shape, struct tia_vec3 centre, tia_q16 size)
{
    const struct tia_vec3 low = {-size, -size, -size}, high = {size, size, size};

    if (shape->kind == TIA_BOX) {
        struct tia_vec3 half = dice_vec3(state, (struct tia_vec3){size / 4, size / 4, size / 4}, high);
        shape->box.min = parts_moved(centre, half, -1);
        shape->box.max = parts_moved(centre, half, 1);
    } else if (shape->kind == TIA_DISC) {
        shape->disc.centre = centre;
        shape->disc.normal = parts_random_direction(state);
        shape->disc.radius = size;
    } else {
        for (int i = 0; i < 3; i++)
            shape->triangle.corner[i] = parts_moved(centre, dice_vec3(state, low, high), 1);
        shape->triangle.corner[0].x -= 2 * size; /* keeps the corners from being collinear */
        shape->triangle.corner[1].y -= 2 * size;
        shape->triangle.corner[2].z -= 2 * size;
    }
}

static void random_geometry(uint64_t *state, struct tia_shape *shape, struct tia_vec3 centre)
{
    tia_q16 size = dice_between(state, TIA_Q16(0.3), TIA_Q16(1.8));

    switch (shape->kind) {
    case TIA_SPHERE:
        shape->sphere.centre = centre;
        shape->sphere.radius = size;
        break;
    case TIA_CYLINDER:
    case TIA_CONE:
        random_round(state, shape, centre, size);
        break;
    case TIA_MESH:
        shape->mesh = dice_next(state) % 2;
        break;
    case TIA_GRID:
        shape->grid = 0;
        break;
    default:
        random_flat(state, shape, centre, size);
    }
}

/* Adds a transform that moves an instance to `centre`. Returns its number, from 1. */
static uint32_t random_transform(uint64_t *state, struct corpus_rays *out, struct tia_vec3 centre)
{
    static const struct tia_vec3 turns[2] = {TIA_VEC3(-180, -180, -180), TIA_VEC3(180, 180, 180)};
    static const struct tia_vec3 scales[2] = {TIA_VEC3(0.5, 0.5, 0.5), TIA_VEC3(1.5, 1.5, 1.5)};
    struct tia_transform *t = &out->transforms[out->scene.transform_count];

    t->position = centre;
    t->rotation = dice_vec3(state, turns[0], turns[1]);
    t->scale = dice_vec3(state, scales[0], scales[1]);
    if (dice_one_in(state, 2))
        t->scale.y = t->scale.z = t->scale.x;
    return ++out->scene.transform_count;
}

/* Makes an object: with probability 1/10 a sphere of the scene's `spheres`, otherwise a shape, but no plane. */
static void random_object(uint64_t *state, struct corpus_rays *out, uint32_t material)
{
    static const enum tia_shape_kind kinds[] = {TIA_SPHERE,   TIA_DISC, TIA_CYLINDER, TIA_CONE, TIA_BOX,
                                                TIA_TRIANGLE, TIA_MESH, TIA_MESH,     TIA_GRID};
    struct tia_vec3 centre = dice_vec3(state, LOW, HIGH);

    if (dice_one_in(state, 10)) {
        struct tia_sphere *sphere = &out->spheres[out->scene.sphere_count++];
        *sphere = (struct tia_sphere){centre, dice_between(state, TIA_Q16(0.3), TIA_Q16(1.8)), material};
        return;
    }
    struct tia_shape *shape = &out->shapes[out->scene.shape_count++];
    shape->kind = kinds[dice_next(state) % (sizeof kinds / sizeof kinds[0])];
    shape->material = material;
    if (shape->kind == TIA_MESH || shape->kind == TIA_GRID || dice_one_in(state, 2)) {
        shape->transform = random_transform(state, out, centre);
        centre = (struct tia_vec3)ZERO;
    }
    random_geometry(state, shape, centre);
}

/* Makes a plane, a disc, a slab or the top of a large ball, at height 0 or slightly tilted; or no ground. */
static void random_ground(uint64_t *state, struct corpus_rays *out)
{
    struct tia_shape *shape = &out->shapes[0];

    switch (dice_next(state) % 6) {
    case 0:
        return;
    case 1:
        *shape = (struct tia_shape){.kind = TIA_DISC, .disc = {ZERO, {0, TIA_Q30_ONE, 0}, TIA_Q16(9)}};
        break;
    case 2:
        *shape = (struct tia_shape){.kind = TIA_BOX, .box = {TIA_VEC3(-9, -0.5, -9), TIA_VEC3(9, 0, 9)}};
        break;
    case 3:
        out->spheres[out->scene.sphere_count++] = (struct tia_sphere){TIA_VEC3(0, -1000, 0), TIA_Q16(1000), 0};
        return;
    default:
        *shape = (struct tia_shape){.kind = TIA_PLANE, .plane = {ZERO, {0, TIA_Q30_ONE, 0}}};
        if (dice_one_in(state, 2))
            shape->plane.normal.x = dice_between(state, TIA_Q30(-0.1), TIA_Q30(0.1));
    }
    out->scene.shape_count = 1;
}

static void connect(struct corpus_rays *out)
{
    struct tia_scene *s = &out->scene;

    s->materials = out->materials;
    s->spheres = out->spheres;
    s->shapes = out->shapes;
    s->transforms = out->transforms;
    s->lights = out->lights;
    s->textures = out->textures;
    s->meshes = out->meshes;
    s->grids = &out->grid;
    s->material_count = CORPUS_RAYS_OBJECTS + 3 + CORPUS_RAYS_NESTED;
    s->texture_count = 3;
    s->mesh_count = 2;
    s->grid_count = 1;
}

void corpus_add_opacity(struct corpus_rays *out, uint64_t seed)
{
    uint64_t state = seed;

    parts_random_opacities(&state, out);
}

void corpus_add_noise(struct corpus_rays *out, uint64_t seed)
{
    uint64_t state = seed;

    for (int i = 0; i < 3; i++) {
        struct tia_texture *t = &out->textures[i];
        if (!dice_one_in(&state, 2))
            continue;
        t->kind = TIA_NOISE;
        t->octaves = (uint8_t)dice_between(&state, 1, TIA_OCTAVES_MAX);
    }
}

void corpus_add_bumps(struct corpus_rays *out, uint64_t seed)
{
    uint64_t state = seed;

    for (uint32_t i = 0; i < out->scene.texture_count; i++)
        out->textures[i].depth = dice_between(&state, TIA_Q16(-0.3), TIA_Q16(0.3));
    for (uint32_t i = 0; i < out->scene.material_count; i++)
        if (dice_one_in(&state, 2))
            out->materials[i].bump = (uint16_t)(1 + dice_next(&state) % out->scene.texture_count);
}

void corpus_add_fog(struct corpus_rays *out, uint64_t seed)
{
    uint64_t state = seed;

    out->fog.colour = dice_rgb(&state, 0, 100);
    out->fog.distance = dice_between(&state, TIA_Q16(0.5), TIA_Q16(60));
    out->fog.height = dice_one_in(&state, 2) ? dice_between(&state, TIA_Q16(0.01), TIA_Q16(6)) : 0;
    out->fog.level = dice_between(&state, TIA_Q16(-3), TIA_Q16(3));
    out->scene.fog = &out->fog;
}

void corpus_random_rays(struct corpus_rays *out, uint64_t seed, unsigned index)
{
    uint64_t state = seed;

    state = dice_next(&state) + index;
    memset(out, 0, sizeof *out);
    connect(out);
    random_camera(&state, &out->scene.camera);
    random_size(&state, out);
    out->scene.background = dice_rgb(&state, 0, 100);
    out->scene.depth = dice_one_in(&state, 4) ? (uint32_t)dice_between(&state, 1, 8) : 0;
    parts_random_textures(&state, out);
    parts_random_meshes(&state, out);
    parts_random_grid(&state, out);
    for (uint32_t i = 0; i < CORPUS_RAYS_OBJECTS + 3; i++)
        parts_random_material(&state, &out->materials[i]);
    random_ground(&state, out);
    uint32_t count = (uint32_t)dice_between(&state, 1, CORPUS_RAYS_OBJECTS);
    for (uint32_t i = 1; i <= count; i++)
        random_object(&state, out, i);
    out->scene.light_count = (uint32_t)dice_between(&state, 1, CORPUS_RAYS_LIGHTS);
    for (uint32_t i = 0; i < out->scene.light_count; i++)
        parts_random_light(&state, &out->lights[i]);
    if (dice_one_in(&state, 3))
        parts_random_nest(&state, out, CORPUS_RAYS_OBJECTS + 3);
}
