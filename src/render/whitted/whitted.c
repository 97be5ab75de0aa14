#include "whitted.h"

#include "observe.h"
#include "shade.h"

/* A pending ray: its throughput, the numbers of bounces and of undeflected passages before it, and its media. */
struct bounce {
    struct ray ray;
    num_length throughput[3];
    uint32_t depth, layers;
    struct media media;
    enum tia_ray kind;
};

/* The pending rays. They are followed depth-first: the reflected ray, then the refracted ray, then the undeflected ray
 * behind a surface whose opacity is below 1. So at most two rays are pending for each bounce before the current one.
 * Undeflected rays come last, so they do not make the stack deeper. */
struct stack {
    struct bounce bounces[2 * TIA_DEPTH_MAX + 1];
    int count;
};

#define THROUGHPUT_MIN (NUM_LENGTH_ONE / 65536)

/* Pushes a ray spawned by b, unless it is too faint. */
static void push(struct stack *stack, const struct ray *ray, const num_length factor[3], const struct bounce *b,
                 const struct media *media, enum tia_ray kind, bool straight)
{
    struct bounce *next = &stack->bounces[stack->count];
    bool counts = false;

    for (int c = 0; c < 3; c++) {
        next->throughput[c] = num_product(b->throughput[c], factor[c]);
        counts = counts || next->throughput[c] >= THROUGHPUT_MIN;
    }
    next->ray = *ray;
    next->depth = b->depth + !straight;
    next->layers = b->layers + straight;
    next->media = *media;
    next->kind = kind;
    stack->count += counts;
}

static void add_flat(const struct tia_rgb *rgb, const num_length throughput[3], num_length colour[3])
{
    num_length flat[3];

    ray_rgb(rgb, flat);
    for (int c = 0; c < 3; c++)
        colour[c] = num_sum_within(colour[c], num_product(flat[c], throughput[c]));
}

static void add_seen_light(const struct ray_light *light, const num_length throughput[3], num_length colour[3])
{
    for (int c = 0; c < 3; c++)
        colour[c] = num_sum_within(colour[c], num_product(light->emission[c], throughput[c]));
}

static void bounce(const struct ray_view *view, const struct shading *s, const struct bounce *b, struct stack *stack)
{
    bool bends = b->depth < view->depth;
    struct bounces next;

    shade_bounce(view, s, &b->media, &next);
    if (!next.straight && s->opacity < NUM_LENGTH_ONE && b->layers < TIA_LAYERS_MAX)
        push(stack, &next.past, next.passes, b, &next.media, TIA_RAY_PAST, true);
    if (next.straight ? b->layers < TIA_LAYERS_MAX : bends)
        push(stack, &next.refracted, next.refracts, b, &next.media, TIA_RAY_REFRACTED, next.straight);
    if (bends)
        push(stack, &next.reflected, next.reflects, b, &b->media, TIA_RAY_REFLECTED, false);
}

static void follow(struct path *path, const struct bounce *b, const struct hit *hit, struct stack *stack,
                   num_length colour[3])
{
    const struct ray_view *view = path->view;
    bool meets = hit->light == TIA_NO_OBJECT && hit->object != TIA_NO_OBJECT;
    struct shading s;

    if (!meets && path_is_watched(path))
        observe_ray(path, b->kind, &b->ray, hit, NULL);
    if (hit->light != TIA_NO_OBJECT) {
        path_hash_word(path, TIA_NO_OBJECT - 1 - hit->light);
        add_seen_light(&view->lights[hit->light], b->throughput, colour);
        return;
    }
    if (hit->object == TIA_NO_OBJECT) {
        path_hash_word(path, TIA_NO_OBJECT);
        add_flat(&view->scene->background, b->throughput, colour);
        return;
    }
    shade_prepare(path, &b->ray, hit, &s);
    if (path_is_watched(path))
        observe_ray(path, b->kind, &b->ray, hit, &s.normal);
    shade_light(path, &s, b->throughput, colour);
    bounce(view, &s, b, stack);
}

void path_colour(struct path *path, const struct ray *ray, const struct hit *first, num_length colour[3])
{
    struct bounce b = {.ray = *ray, .throughput = {NUM_LENGTH_ONE, NUM_LENGTH_ONE, NUM_LENGTH_ONE}};
    uint32_t rays = 1;
    struct hit hit = *first;
    struct stack stack;

    colour[0] = colour[1] = colour[2] = 0;
    stack.count = 0;
    follow(path, &b, &hit, &stack, colour);
    path->known = false;
    path->next_reached = PATH_REACHED;
    while (stack.count > 0 && rays++ < TIA_RAYS_MAX && !path_stops(path)) {
        b = stack.bounces[--stack.count];
        observe_count(path, &b.ray);
        ray_intersect(path->view, &b.ray, &hit);
        ray_intersect_lights(path->view, &b.ray, &hit);
        follow(path, &b, &hit, &stack, colour);
    }
}
