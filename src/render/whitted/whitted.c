#include "whitted.h"

#include "cone.h"
#include "observe.h"
#include "render/trace/fog.h"

/* The pending rays. They are followed depth-first: the reflected ray, then the refracted ray, then the undeflected ray
 * behind a surface whose opacity is below 1. So at most two rays are pending for each bounce before the current one.
 * Undeflected rays come last, so they do not make the stack deeper. */
struct stack {
    struct bounce bounces[2 * TIA_DEPTH_MAX + 1];
    int count;
};

#define THROUGHPUT_MIN (NUM_LENGTH_ONE / 65536)

/* Sets the ray that b spawns. Returns false if it is too faint. */
static bool spawn(struct bounce *next, const struct ray *ray, const num_length factor[3], const struct bounce *b,
                  const struct media *media, enum tia_ray kind, bool straight)
{
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
    return counts;
}

static void follow_cone(struct path *path, const struct bounce *b)
{
#if TIA_FOOTPRINTS
    if (path->view->filtered)
        path->cone = b->cone;
#else
    (void)path;
    (void)b;
#endif
}

/* Pushes a ray spawned by b, unless it is too faint. */
static void push(struct stack *stack, const struct ray *ray, const num_length factor[3], const struct bounce *b,
                 const struct media *media, enum tia_ray kind, bool straight)
{
    stack->count += spawn(&stack->bounces[stack->count], ray, factor, b, media, kind, straight);
}

/* Gives the rays from number `first` on, which leave the hit of the ray b, their cones. */
static void set_cones(const struct path *path, const struct bounce *b, const struct hit *hit, const struct shading *s,
                      struct bounces *next, struct stack *stack, int first)
{
#if TIA_FOOTPRINTS
    if (!path->view->filtered || stack->count == first)
        return;
    cone_spread(path, &b->ray, hit, s, next);
    for (int i = first; i < stack->count; i++) {
        struct bounce *spawned = &stack->bounces[i];
        spawned->cone = (struct cone){next->width, next->spread[spawned->kind - TIA_RAY_REFLECTED]};
    }
#else
    (void)path, (void)b, (void)hit, (void)s, (void)next, (void)stack, (void)first;
#endif
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

static void bounce(const struct path *path, const struct shading *s, const struct bounce *b, const struct hit *hit,
                   struct stack *stack)
{
    bool bends = b->depth < path->view->depth;
    const int first = stack->count;
    struct bounces next;

    shade_bounce(path->view, s, &b->media, &next);
    if (!next.straight && s->opacity < NUM_LENGTH_ONE && b->layers < TIA_LAYERS_MAX)
        push(stack, &next.past, next.passes, b, &next.media, TIA_RAY_PAST, true);
    if (next.straight ? b->layers < TIA_LAYERS_MAX : bends)
        push(stack, &next.refracted, next.refracts, b, &next.media, TIA_RAY_REFRACTED, next.straight);
    if (bends)
        push(stack, &next.reflected, next.reflects, b, &b->media, TIA_RAY_REFLECTED, false);
    set_cones(path, b, hit, s, &next, stack, first);
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
    bounce(path, &s, b, hit, stack);
}

/* Adds the fog along the ray b, and then what the ray meets. */
static void look(struct path *path, struct bounce *b, const struct hit *hit, struct stack *stack, num_length colour[3])
{
    const struct tia_fog *fog = path->view->scene->fog;

    if (fog && !b->media.count)
        ray_fog_veil(fog, &b->ray, hit, b->throughput, colour);
    follow(path, b, hit, stack, colour);
}

/* Follows the ray b, whose hit is known, and all rays that it spawns. Returns their number. */
static uint32_t follow_all(struct path *path, struct bounce *b, struct hit *hit, num_length colour[3])
{
    uint32_t rays = 1;
    struct stack stack;

    colour[0] = colour[1] = colour[2] = 0;
    stack.count = 0;
    look(path, b, hit, &stack, colour);
    path->known = false;
    path->pixel = NULL;
    path->next_reached = PATH_REACHED;
    while (stack.count > 0 && rays++ < TIA_RAYS_MAX && !path_stops(path)) {
        *b = stack.bounces[--stack.count];
        follow_cone(path, b);
        observe_count(path, &b->ray);
        ray_intersect(path->view, &b->ray, hit);
        ray_intersect_lights(path->view, &b->ray, hit);
        look(path, b, hit, &stack, colour);
    }
    return rays;
}

void path_colour(struct path *path, const struct ray *ray, const struct hit *first, num_length colour[3])
{
    struct bounce b = {.ray = *ray, .throughput = {NUM_LENGTH_ONE, NUM_LENGTH_ONE, NUM_LENGTH_ONE}};
    struct hit hit = *first;

    (void)follow_all(path, &b, &hit, colour);
}

uint32_t path_resume(struct path *path, struct bounce *b, const struct path_route *route, num_length colour[3])
{
    const struct ray_view *view = path->view;
    struct hit hit;

    for (uint32_t i = 0; i < route->count; i++) {
        bool refracted = route->step[i] & PATH_REFRACTED;
        const struct bounce before = *b;
        struct bounces next;
        struct shading s;
        ray_intersect_object(view, &b->ray, route->step[i] & ~PATH_REFRACTED, &hit);
        shading_prepare(view, view->bias, &b->ray, &hit, &s);
        shade_bounce(view, &s, &before.media, &next);
        if (refracted)
            (void)spawn(b, &next.refracted, next.refracts, &before, &next.media, TIA_RAY_REFRACTED, next.straight);
        else
            (void)spawn(b, &next.reflected, next.reflects, &before, &before.media, TIA_RAY_REFLECTED, false);
    }
    ray_intersect(view, &b->ray, &hit);
    ray_intersect_lights(view, &b->ray, &hit);
    return follow_all(path, b, &hit, colour);
}
