/* check.c - tia_scene_check on any numbers: a scene that is refused has a fault, and an accepted one is within the
 * ranges that include/tia/scene.h states, computed here in double. */
#include <math.h>
#include <stdio.h>

#include "general.h"

static bool is_unit(struct tia_rgb c)
{
    return c.r >= 0 && c.g >= 0 && c.b >= 0 && c.r <= TIA_Q30_ONE && c.g <= TIA_Q30_ONE && c.b <= TIA_Q30_ONE;
}

/* True if a point is near the eye, with a tolerance of 2^-16 for the rounding of double; test_scene tests the exact
 * limit. */
static bool is_near(const struct tia_scene *s, struct tia_vec3 p, tia_q16 radius)
{
    double x = (double)p.x - s->camera.eye.x, y = (double)p.y - s->camera.eye.y, z = (double)p.z - s->camera.eye.z;
    return sqrt(x * x + y * y + z * z) + radius < 2147483649.0;
}

static void must_be_light(const struct tia_scene *s, const struct tia_light *l)
{
    bool placed = l->kind != TIA_DIRECTIONAL_LIGHT && l->kind != TIA_AMBIENT_LIGHT;
    bool radius = l->kind == TIA_POINT_LIGHT || l->kind == TIA_DISC_LIGHT || l->kind == TIA_SPHERE_LIGHT;
    double x = l->direction.x, y = l->direction.y, z = l->direction.z, direction = sqrt(x * x + y * y + z * z);

    MUST(l->kind <= TIA_SPHERE_LIGHT);
    MUST(!radius || l->radius == 0 || l->radius >= TIA_RADIUS_MIN);
    MUST(!placed || is_near(s, l->centre, radius ? l->radius : 0));
    MUST(l->emission.r >= 0 && l->emission.g >= 0 && l->emission.b >= 0);
    MUST(!placed || (l->constant >= 0 && l->linear >= 0 && l->quadratic >= 0));
    if (l->kind == TIA_DIRECTIONAL_LIGHT || l->kind == TIA_SPOT_LIGHT || l->kind == TIA_DISC_LIGHT)
        MUST(direction > 0.4999 * TIA_Q30_ONE && direction < 1.5001 * TIA_Q30_ONE);
    MUST(l->kind != TIA_SPOT_LIGHT || (0 <= l->inner && l->inner <= l->outer && l->outer <= TIA_Q16(90)));
    MUST(l->kind < TIA_RECTANGLE_LIGHT || l->samples <= TIA_LIGHT_SAMPLES_MAX);
}

static void must_keep_ranges(const struct tia_scene *s)
{
    MUST(s->camera.projection != TIA_PERSPECTIVE || (s->camera.fov >= TIA_FOV_MIN && s->camera.fov <= TIA_FOV_MAX));
    MUST(is_unit(s->background));
    for (uint32_t i = 0; i < s->material_count; i++)
        MUST(is_unit(s->materials[i].colour) && is_unit(s->materials[i].transmission) &&
             is_unit(s->materials[i].emission));
    for (uint32_t i = 0; i < s->sphere_count; i++) {
        MUST(s->spheres[i].radius >= TIA_RADIUS_MIN && s->spheres[i].material < s->material_count);
        MUST(is_near(s, s->spheres[i].centre, s->spheres[i].radius));
    }
    for (uint32_t i = 0; i < s->light_count; i++)
        must_be_light(s, &s->lights[i]);
}

static double length(double x, double y, double z)
{
    return sqrt(x * x + y * y + z * z);
}

static void must_be_camera(const struct tia_camera *c)
{
    const struct tia_window *w = &c->window;
    double nx = (double)c->eye.x - c->reference.x, ny = (double)c->eye.y - c->reference.y,
           nz = (double)c->eye.z - c->reference.z, n = length(nx, ny, nz), up = length(c->up.x, c->up.y, c->up.z);

    MUST(c->projection == TIA_PERSPECTIVE || (w->bottom < w->top && (w->left < w->right || !(w->left | w->right))));
    MUST(c->projection != TIA_FRUSTUM || w->near > 0);
    MUST(c->samples <= 1 || c->samples == 4 || c->samples == 16);
    if (up > 0)
        MUST(n > 0 && length(c->up.y * nz - c->up.z * ny, c->up.z * nx - c->up.x * nz, c->up.x * ny - c->up.y * nx) >
                          n * up * 0.00097);
}

/* Checks the distance of each corner of an object's box from each position of the eye, with a tolerance for the margin
 * of the box and rounding. */
static void must_be_near(const struct tia_scene *s, struct tia_bounds b)
{
    const double far = 2147483648.0 + 16;

    for (int i = 0; i < 8 && b.min.x <= b.max.x; i++) {
        double x = i & 1 ? b.min.x : b.max.x, y = i & 2 ? b.min.y : b.max.y, z = i & 4 ? b.min.z : b.max.z;
        MUST(length(x - s->camera.eye.x, y - s->camera.eye.y, z - s->camera.eye.z) < far);
        for (uint32_t k = 0; k < s->track_count; k++)
            for (uint32_t n = 0; s->tracks[k].target == TIA_MOVES_EYE && n < s->tracks[k].key_count; n++) {
                struct tia_vec3 eye = s->tracks[k].keys[n].value;
                MUST(length(x - eye.x, y - eye.y, z - eye.z) < far);
            }
    }
}

static void must_be_placed(const struct tia_transform *t, struct tia_bounds b)
{
    double least = fmin(t->scale.x, fmin(t->scale.y, t->scale.z)) / 65536;

    MUST(least >= 1.0 / 1024 && t->scale.x <= 1024 << 16 && t->scale.y <= 1024 << 16 && t->scale.z <= 1024 << 16);
    MUST(b.max.x < b.min.x ||
         length((double)b.max.x - b.min.x, (double)b.max.y - b.min.y, (double)b.max.z - b.min.z) / 2 <
             least * 2147483648.0);
}

static void must_be_shape(const struct tia_scene *s, uint32_t i)
{
    const struct tia_shape *shape = &s->shapes[i];
    struct tia_bounds b = tia_object_bounds(s, s->sphere_count + i);

    MUST(shape->material < s->material_count && shape->transform <= s->transform_count);
    MUST(shape->kind != TIA_MESH || shape->mesh < s->mesh_count);
    MUST(shape->kind != TIA_GRID || shape->grid < s->grid_count);
    if (shape->kind == TIA_SPHERE && !shape->transform)
        MUST(is_near(s, shape->sphere.centre, shape->sphere.radius));
    else
        must_be_near(s, b);
    if (shape->transform)
        must_be_placed(&s->transforms[shape->transform - 1], b);
}

/* Checks that the hierarchy and the moved elements of a scene fit into memory of the size that the library returns, and
 * that the scene at a time is valid or out of range. */
static void must_be_of_use(const struct tia_scene *s)
{
    const tia_q16 times[] = {INT32_MIN, 0, 1, 65536, 1 << 20, INT32_MAX};
    size_t size = tia_bvh_size(s), moving = tia_scene_at_size(s), used;
    void *memory = malloc(size), *moved = malloc(moving);
    struct tia_scene with = *s, at;

    MUST(tia_bvh_build(&with.bvh, memory, size - 1, &used, s, NULL) == TIA_ERR_MEMORY);
    MUST(!tia_bvh_build(&with.bvh, memory, size, &used, s, NULL) && used <= size);
    MUST(!tia_scene_check(&with, NULL));
    for (unsigned i = 0; i < sizeof times / sizeof *times; i++) {
        MUST(!tia_scene_at(&at, moved, moving, &with, times[i], NULL));
        int status = tia_scene_check(&at, NULL);
        MUST(!status || (tia_scene_moves(s) && status == TIA_ERR_RANGE));
    }
    MUST(tia_scene_duration(s) >= 0);
    free(memory);
    free(moved);
}

/* Checks that the scene is still valid after a key, which may change the lights, apart from tracks of lights. */
static void must_stay_accepted(const struct fuzz_scene *f, struct bytes *b)
{
    struct tia_light lights[FUZZ_LIGHTS + 1];
    struct tia_scene moved = f->scene;
    uint32_t count = moved.light_count;

    moved.tracks = NULL;
    moved.track_count = 0;
    for (uint32_t i = 0; i < count; i++)
        lights[i] = f->lights[i];
    moved.lights = lights;
    for (int presses = 0; presses < 16; presses++) {
        uint16_t key = (uint16_t)(take_byte(b) | (take_byte(b) & 1) << 8);
        int changed = tia_viewer_press(&f->scene, lights, &count, FUZZ_LIGHTS + 1, key);
        MUST(changed == 0 || changed == 1 || changed == TIA_ERR_ARGUMENT);
        MUST(count <= FUZZ_LIGHTS + 1);
        moved.light_count = count;
        MUST(!tia_scene_check(&moved, NULL));
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct bytes b = {data, size};
    struct fuzz_scene f;
    struct fuzz_general g;
    struct tia_fault fault = {NULL, 0, NULL, NULL};
    int status;

    take_scene(&b, &f);
    if (take_byte(&b) == 255)
        f.scene.spheres = NULL;
    take_general(&b, &f, &g);
    status = tia_scene_check(&f.scene, &fault);
    MUST(status == tia_scene_check(&f.scene, NULL));
    if (!status) {
        must_keep_ranges(&f.scene);
        must_be_camera(&f.scene.camera);
        for (uint32_t i = 0; i < f.scene.shape_count; i++)
            must_be_shape(&f.scene, i);
        must_be_of_use(&f.scene);
        must_stay_accepted(&f, &b);
    } else {
        MUST(status == TIA_ERR_RANGE && fault.thing && fault.field && fault.rule && *fault.rule);
    }
    return 0;
}
