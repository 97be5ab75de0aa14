/* check.c - tia_scene_check on any numbers at all: it names the fault of what it refuses, and what
 * it accepts keeps the ranges that include/tia/scene.h states, computed here in double. */
#include <math.h>
#include <stdio.h>

#include "bytes.h"

static bool is_unit(struct tia_rgb c)
{
    return c.r >= 0 && c.g >= 0 && c.b >= 0 && c.r <= TIA_Q30_ONE && c.g <= TIA_Q30_ONE && c.b <= TIA_Q30_ONE;
}

/* A tolerance of one 2^-16 for double's rounding; the exact limit is test_scene's. */
static bool is_near(const struct tia_scene *s, struct tia_vec3 p, tia_q16 radius)
{
    double x = (double)p.x - s->camera.eye.x, y = (double)p.y - s->camera.eye.y, z = (double)p.z - s->camera.eye.z;
    return sqrt(x * x + y * y + z * z) + radius < 2147483649.0;
}

static void must_keep_ranges(const struct tia_scene *s)
{
    MUST(s->camera.fov >= TIA_FOV_MIN && s->camera.fov <= TIA_FOV_MAX);
    MUST(is_unit(s->background));
    for (uint32_t i = 0; i < s->material_count; i++)
        MUST(is_unit(s->materials[i].colour) && is_unit(s->materials[i].transmission) &&
             is_unit(s->materials[i].emission));
    for (uint32_t i = 0; i < s->sphere_count; i++) {
        MUST(s->spheres[i].radius >= TIA_RADIUS_MIN && s->spheres[i].material < s->material_count);
        MUST(is_near(s, s->spheres[i].centre, s->spheres[i].radius));
    }
    for (uint32_t i = 0; i < s->light_count; i++) {
        MUST(s->lights[i].radius == 0 || s->lights[i].radius >= TIA_RADIUS_MIN);
        MUST(is_near(s, s->lights[i].centre, s->lights[i].radius));
        MUST(s->lights[i].emission.r >= 0 && s->lights[i].emission.g >= 0 && s->lights[i].emission.b >= 0);
    }
}

/* A key may change the lights; it must leave a scene that is accepted. */
static void must_stay_accepted(const struct fuzz_scene *f, struct bytes *b)
{
    struct tia_light lights[FUZZ_LIGHTS + 1];
    struct tia_scene moved = f->scene;
    uint32_t count = moved.light_count;

    for (uint32_t i = 0; i < count; i++)
        lights[i] = f->lights[i];
    moved.lights = lights;
    for (int presses = 0; presses < 16; presses++) {
        uint16_t key = (uint16_t)(take_byte(b) | (take_byte(b) & 1) << 8);
        int changed = tia_press(&f->scene, lights, &count, FUZZ_LIGHTS + 1, key);
        MUST(changed == 0 || changed == 1 || changed == TIA_ERR_ARGUMENT);
        MUST(count <= FUZZ_LIGHTS + 1);
        moved.light_count = count;
        MUST(tia_scene_check(&moved, NULL) == TIA_OK);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct bytes b = {data, size};
    struct fuzz_scene f;
    struct tia_fault fault = {NULL, 0, NULL, NULL};
    int status;

    take_scene(&b, &f);
    if (take_byte(&b) == 255)
        f.scene.spheres = NULL;
    status = tia_scene_check(&f.scene, &fault);
    MUST(status == tia_scene_check(&f.scene, NULL));
    if (status == TIA_OK) {
        must_keep_ranges(&f.scene);
        must_stay_accepted(&f, &b);
    } else {
        MUST(status == TIA_ERR_RANGE && fault.thing && fault.field && fault.rule && *fault.rule);
    }
    return 0;
}
