#include "float_loop.h"

#include <math.h>
#include <stdlib.h>

struct vec {
    float x, y, z;
};

struct ball {
    struct vec centre;
    float radius, colour[3];
};

struct world {
    struct ball *balls;
    int ball_count;
    struct vec eye, light;
    float emission[3], background[3];
    bool lit;
};

static struct vec add(struct vec a, struct vec b)
{
    return (struct vec){a.x + b.x, a.y + b.y, a.z + b.z};
}
static struct vec sub(struct vec a, struct vec b)
{
    return (struct vec){a.x - b.x, a.y - b.y, a.z - b.z};
}
static struct vec scale(struct vec a, float f)
{
    return (struct vec){a.x * f, a.y * f, a.z * f};
}
static float dot(struct vec a, struct vec b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
static struct vec normalise(struct vec a)
{
    return scale(a, 1 / sqrtf(dot(a, a)));
}

static bool intersect(const struct ball *ball, struct vec origin, struct vec direction, float *t)
{
    struct vec l = sub(ball->centre, origin);
    float tca = dot(l, direction);
    if (tca < 0)
        return false;
    struct vec p = sub(l, scale(direction, tca));
    float d2 = dot(p, p), r2 = ball->radius * ball->radius;
    if (d2 > r2)
        return false;
    float thc = sqrtf(r2 - d2);
    *t = tca - thc >= 0 ? tca - thc : tca + thc;
    return true;
}

static bool in_shadow(const struct world *world, struct vec p, struct vec n, struct vec direction, float distance)
{
    struct vec origin = add(p, scale(n, 1.0f / 8192));
    float t;

    for (int i = 0; i < world->ball_count; i++)
        if (intersect(&world->balls[i], origin, direction, &t) && t < distance)
            return true;
    return false;
}

static void shade(const struct world *world, const struct ball *ball, struct vec p, float colour[3])
{
    struct vec n = scale(sub(p, ball->centre), 1 / ball->radius), to = sub(world->light, p);
    float distance = sqrtf(dot(to, to)), lambert = dot(n, to) / distance;

    colour[0] = colour[1] = colour[2] = 0;
    if (!world->lit || lambert <= 0 || in_shadow(world, p, n, scale(to, 1 / distance), distance))
        return;
    for (int c = 0; c < 3; c++)
        colour[c] = ball->colour[c] * lambert * world->emission[c];
}

static void trace(const struct world *world, struct vec direction, float colour[3])
{
    const struct ball *nearest = NULL;
    float best = 0, t;

    for (int i = 0; i < world->ball_count; i++)
        if (intersect(&world->balls[i], world->eye, direction, &t) && (!nearest || t < best)) {
            nearest = &world->balls[i];
            best = t;
        }
    if (nearest) {
        shade(world, nearest, add(world->eye, scale(direction, best)), colour);
        return;
    }
    for (int c = 0; c < 3; c++)
        colour[c] = world->background[c];
}

static float from_q16(tia_q16 q)
{
    return (float)q / 65536;
}
static struct vec to_vec(struct tia_vec3 v)
{
    return (struct vec){from_q16(v.x), from_q16(v.y), from_q16(v.z)};
}

static void to_float(struct tia_rgb c, float out[3])
{
    out[0] = (float)c.r / 1073741824;
    out[1] = (float)c.g / 1073741824;
    out[2] = (float)c.b / 1073741824;
}

static void make_world(const struct tia_scene *scene, struct world *world)
{
    world->ball_count = (int)scene->sphere_count;
    world->balls = malloc(scene->sphere_count * sizeof *world->balls);
    if (!world->balls)
        abort();
    for (uint32_t i = 0; i < scene->sphere_count; i++) {
        world->balls[i].centre = to_vec(scene->spheres[i].centre);
        world->balls[i].radius = from_q16(scene->spheres[i].radius);
        to_float(scene->materials[scene->spheres[i].material].colour, world->balls[i].colour);
    }
    world->eye = to_vec(scene->camera.eye);
    to_float(scene->background, world->background);
    world->lit = scene->light_count > 0;
    if (world->lit) {
        world->light = to_vec(scene->lights[0].centre);
        to_float(scene->lights[0].emission, world->emission);
    }
}

static unsigned level(float c, float levels)
{
    return (unsigned)((c < 0 ? 0 : c > 1 ? 1 : c) * levels + 0.5f);
}

void plain_render(const struct tia_scene *scene, int width, int height, tia_rgb565 *pixels)
{
    struct world world = {0};
    float a = tanf(from_q16(scene->camera.fov) * 3.14159265f / 360), w = (float)width, h = (float)height, colour[3];

    make_world(scene, &world);
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            struct vec d = {(2 * ((float)x + 0.5f) / w - 1) * a * w / h, (1 - 2 * ((float)y + 0.5f) / h) * a, -1};
            trace(&world, normalise(d), colour);
            *pixels++ = (tia_rgb565)(level(colour[0], 31) << 11 | level(colour[1], 63) << 5 | level(colour[2], 31));
        }
    free(world.balls);
}
