#include "whitted.h"

#include "shade.h"

/* A ray on its way: what its colour will be multiplied by, and how often it was bent. */
struct bounce {
    struct ray ray;
    num_length throughput[3];
    uint32_t depth;
};

/* Depth-first, the reflected ray before the refracted one: each level leaves at most one ray behind. */
struct stack {
    struct bounce bounces[TIA_DEPTH_MAX + 2];
    int count;
};

#define THROUGHPUT_MIN (NUM_LENGTH_ONE / 65536)

static void push(struct stack *stack, const struct ray *ray, const num_length throughput[3], const num_length factor[3],
                 uint32_t depth)
{
    struct bounce *b = &stack->bounces[stack->count];
    bool counts = false;

    for (int c = 0; c < 3; c++) {
        b->throughput[c] = num_product(throughput[c], factor[c]);
        counts = counts || b->throughput[c] >= THROUGHPUT_MIN;
    }
    b->ray = *ray;
    b->depth = depth;
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

static void follow(struct path *path, const struct bounce *b, const struct hit *hit, struct stack *stack,
                   num_length colour[3])
{
    const struct ray_view *view = path->view;
    struct shading s;
    struct bounces next;

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
    shade_light(path, &s, b->throughput, colour);
    if (b->depth >= view->depth)
        return;
    shade_bounce(&s, &next);
    push(stack, &next.refracted, b->throughput, next.refracts, b->depth + 1);
    push(stack, &next.reflected, b->throughput, next.reflects, b->depth + 1);
}

void path_colour(struct path *path, const struct ray *ray, const struct hit *first, num_length colour[3])
{
    struct bounce b = {*ray, {NUM_LENGTH_ONE, NUM_LENGTH_ONE, NUM_LENGTH_ONE}, 0};
    struct hit hit = *first;
    struct stack stack;

    colour[0] = colour[1] = colour[2] = 0;
    stack.count = 0;
    follow(path, &b, &hit, &stack, colour);
    while (stack.count > 0 && !path_stops(path)) {
        b = stack.bounces[--stack.count];
        ray_intersect(path->view, &b.ray, &hit);
        ray_intersect_lights(path->view, &b.ray, &hit);
        follow(path, &b, &hit, &stack, colour);
    }
}
