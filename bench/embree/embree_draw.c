/* embree_draw.c - pictures by single rays, one after the other. */
#include "embree_shade.h"
#include "embree_waves.h"

/* A pending ray: each ray spawns two more at most, one level deeper. */
struct pending {
    struct float_ray ray;
    float throughput[3];
    unsigned depth;
};

struct pixel {
    const struct embree *embree;
    struct pending stack[EMBREE_DEPTH + 2];
    unsigned waiting;
    float colour[3];
};

static void add_light(const struct embree *e, const struct point *p, const struct embree_light *light, float own[3])
{
    struct embree_context context;
    struct lighting lit;
    float through[1][3] = {{1, 1, 1}};

    if (!find_lighting(p, light, &lit))
        return;
    struct RTCRay shadow = ray_of(&lit.shadow, lit.distance);
    rtcInitIntersectContext(&context.context);
    context.through = through;
    rtcOccluded1(e->made.scene, &context.context, &shadow);
    for (int c = 0; c < 3 && shadow.tfar >= 0; c++)
        own[c] += lit.part[c] * through[0][c];
}

static void add(struct pixel *pixel, const float colour[3], const float by[3])
{
    for (int c = 0; c < 3; c++)
        pixel->colour[c] += colour[c] * by[c];
}

static void trace(struct pixel *pixel, const struct pending *now)
{
    const struct embree *e = pixel->embree;
    struct RTCRayHit found;
    struct point point;
    struct bounces bounces;
    float own[3] = {0, 0, 0};

    if (!meet_nearest(e->made.scene, &now->ray, 1e30F, &found)) {
        add(pixel, e->background, now->throughput);
        return;
    }
    find_point(e, &now->ray, &found.hit, found.ray.tfar, &point);
    for (uint32_t i = 0; i < e->given->light_count; i++)
        add_light(e, &point, &e->lights[i], own);
    add(pixel, own, now->throughput);
    if (now->depth >= e->depth)
        return;
    find_bounces(&point, &bounces);
    for (int i = 0; i < bounces.count; i++) {
        struct pending *next = &pixel->stack[pixel->waiting];
        next->ray = bounces.ray[i];
        next->depth = now->depth + 1;
        pixel->waiting += scale_throughput(now->throughput, bounces.part[i], next->throughput);
    }
}

static tia_rgb565 draw_pixel(const struct embree *e, const struct float_ray *ray)
{
    struct pixel pixel; /* the stack is not cleared: that would take a tenth of the time */

    pixel.embree = e;
    pixel.waiting = 1;
    pixel.colour[0] = pixel.colour[1] = pixel.colour[2] = 0;
    pixel.stack[0] = (struct pending){*ray, {1, 1, 1}, 0};
    while (pixel.waiting) {
        struct pending now = pixel.stack[--pixel.waiting];
        trace(&pixel, &now);
    }
    return pixel_of(pixel.colour);
}

static void draw_single(const struct embree *e, const struct eye_rays *eye, tia_rgb565 *pixels)
{
    for (unsigned y = 0; y < eye->height; y++)
        for (unsigned x = 0; x < eye->width; x++) {
            struct float_ray ray = eye_ray(eye, x, y);
            pixels[(size_t)y * eye->width + x] = draw_pixel(e, &ray);
        }
}

const char *const embree_ways[] = {[EMBREE_SINGLE] = "Embree",
                                   [EMBREE_PACKETS_8] = "Embree, packets of 8",
                                   [EMBREE_PACKETS_16] = "Embree, packets of 16",
                                   [EMBREE_FIRST_8] = "Embree, 8 and single",
                                   [EMBREE_FIRST_16] = "Embree, 16 and single",
                                   [EMBREE_STREAMS] = "Embree, streams"};

bool embree_draw(const struct embree *e, enum embree_way way, uint16_t width, uint16_t height, tia_rgb565 *pixels)
{
    const struct eye_rays eye = eye_rays_of(e->given, width, height);
    unsigned before = set_modes(FLUSH_TO_ZERO);
    bool drawn = true;

    if (way == EMBREE_SINGLE)
        draw_single(e, &eye, pixels);
    else
        drawn = embree_draw_waves(e, way, &eye, pixels);
    (void)set_modes(before);
    return drawn;
}
