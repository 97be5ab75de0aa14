#include "corpus.h"

#include <string.h>

#include <tia/viewer.h>

#include "dice.h"

#define GROUND 10000

/* Chooses a size, small ones more often than large ones: on average some 350,000 pixels per scene. */
static void random_size(uint64_t *state, struct corpus_scene *out)
{
    static const uint16_t sizes[][2] = {{320, 240}, {320, 240}, {321, 243}, {400, 300}, {400, 300},  {480, 270},
                                        {512, 384}, {512, 384}, {640, 360}, {640, 480}, {640, 480},  {799, 601},
                                        {854, 480}, {240, 320}, {320, 240}, {640, 480}, {1280, 720}, {1920, 1080}};
    uint64_t i = dice_next(state) % (sizeof sizes / sizeof sizes[0]);

    out->width = sizes[i][0];
    out->height = sizes[i][1];
}

static void random_camera(uint64_t *state, struct tia_camera *camera)
{
    camera->eye.x = dice_between(state, TIA_Q16(-50), TIA_Q16(50));
    camera->eye.z = dice_between(state, TIA_Q16(-50), TIA_Q16(50));
    camera->eye.y = dice_one_in(state, 2) ? dice_between(state, TIA_Q16(0.5), TIA_Q16(8))
                                          : dice_between(state, TIA_Q16(0.5), TIA_Q16(60));
    camera->fov = dice_between(state, TIA_Q16(10), TIA_Q16(90));
}

/* Returns roughly the largest distance from the axis at which an object at `distance` is in view: tan(fov/2) is about
 * fov/115 up to 60 degrees, and larger beyond. */
static tia_q16 sight(const struct tia_camera *camera, tia_q16 distance)
{
    return (tia_q16)((int64_t)distance * (camera->fov >> 16) / 115);
}

/* Places a ball in view. Half of the balls lie on the ground, at least as far away as the nearest visible point of the
 * ground, whose top is at y = 0. */
static void place_ball(uint64_t *state, const struct tia_camera *camera, struct tia_sphere *ball)
{
    tia_q16 r = ball->radius, distance = dice_between(state, r + TIA_Q16_ONE, r + TIA_Q16(50));
    bool lying = dice_one_in(state, 2);

    if (lying)
        distance += camera->eye.y / (camera->fov >> 16) * 115;
    tia_q16 aside = sight(camera, distance) / 3 * 4;
    tia_q16 up = sight(camera, distance);
    ball->centre.x = camera->eye.x + dice_between(state, -aside, aside);
    ball->centre.z = camera->eye.z - distance;
    ball->centre.y = camera->eye.y + dice_between(state, -up, up);
    if (lying || ball->centre.y < -r)
        ball->centre.y = r;
}

/* Places a ball beside, above or behind the previous one, exactly touching it. */
static void touch(uint64_t *state, const struct tia_sphere *before, struct tia_sphere *ball)
{
    tia_q16 reach = before->radius + ball->radius;

    ball->centre = before->centre;
    switch (dice_next(state) % 3) {
    case 0:
        ball->centre.x += reach;
        break;
    case 1:
        ball->centre.y += reach;
        break;
    default:
        ball->centre.z -= reach;
    }
}

static void random_balls(uint64_t *state, struct corpus_scene *out, bool clear, bool glow)
{
    uint32_t count = 1 + (uint32_t)dice_between(state, 1, CORPUS_BALLS);

    for (uint32_t i = 1; i < count; i++) {
        struct tia_sphere *ball = &out->spheres[i];
        ball->material = i;
        ball->radius = dice_between(state, TIA_Q16(0.25), dice_one_in(state, 2) ? TIA_Q16(2) : TIA_Q16(6));
        place_ball(state, &out->scene.camera, ball);
        if (i > 1 && dice_one_in(state, 3))
            touch(state, ball - 1, ball);
        out->materials[i].colour = dice_rgb(state, 0, 100);
        if (clear && dice_one_in(state, 2))
            out->materials[i].transmission = dice_rgb(state, 0, 100);
        if (glow && dice_one_in(state, 2))
            out->materials[i].emission = dice_rgb(state, 0, 40);
    }
    out->scene.sphere_count = out->scene.material_count = count;
}

/* Places lights above the ground, many of them in view; some have radius 0. */
static void random_lights(uint64_t *state, struct corpus_scene *out)
{
    const struct tia_vec3 *eye = &out->scene.camera.eye;
    uint32_t count = (uint32_t)dice_between(state, 1, CORPUS_LIGHTS);

    for (uint32_t i = 0; i < count; i++) {
        struct tia_light *light = &out->lights[i];
        light->centre.x = eye->x + dice_between(state, TIA_Q16(-40), TIA_Q16(40));
        light->centre.y = dice_between(state, TIA_Q16(2), TIA_Q16(60));
        light->centre.z = eye->z - dice_between(state, TIA_Q16(-30), TIA_Q16(50));
        light->radius = dice_one_in(state, 3) ? 0 : dice_between(state, TIA_Q16(0.25), TIA_Q16(3));
        light->emission = dice_rgb(state, 20, 100);
    }
    out->scene.light_count = count;
}

static void connect(struct corpus_scene *out)
{
    out->scene.materials = out->materials;
    out->scene.spheres = out->spheres;
    out->scene.lights = out->lights;
}

void corpus_random(struct corpus_scene *out, uint64_t seed, unsigned index)
{
    uint64_t state = seed;

    state = dice_next(&state) + index;
    memset(out, 0, sizeof *out);
    connect(out);
    random_size(&state, out);
    random_camera(&state, &out->scene.camera);
    out->scene.background = dice_rgb(&state, 0, 100);
    out->spheres[0] = (struct tia_sphere){TIA_VEC3(0, -GROUND, 0), TIA_Q16(GROUND), 0};
    out->materials[0].colour = dice_rgb(&state, 30, 100);
    random_balls(&state, out, index % 4 == 3, index % 5 == 4);
    random_lights(&state, out);
}

int corpus_thesis(struct corpus_scene *out, const char *keys, unsigned width, unsigned height)
{
    memset(out, 0, sizeof *out);
    out->scene = tia_thesis_scene;
    out->scene.lights = out->lights;
    out->width = width;
    out->height = height;
    for (; *keys != '\0'; keys++) {
        int changed = tia_viewer_press(&tia_thesis_scene, out->lights, &out->scene.light_count, CORPUS_LIGHTS,
                                       (unsigned char)*keys);
        if (changed < 0)
            return changed;
    }
    return TIA_OK;
}
