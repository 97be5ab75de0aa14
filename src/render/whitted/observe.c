#include "observe.h"

static tia_q16 q16_of(num_length x)
{
    if (x >= num_integer(32767) || x <= num_integer(-32767))
        return x > 0 ? INT32_MAX : -INT32_MAX;
    int32_t whole = num_floor(x);
    return whole * TIA_Q16_ONE + num_floor((x - num_integer(whole)) * TIA_Q16_ONE + NUM_LENGTH_ONE / 2);
}

static struct tia_vec3 vec_of(struct num_point p)
{
    return (struct tia_vec3){q16_of(p.x), q16_of(p.y), q16_of(p.z)};
}

static struct tia_vec3 normal_of(struct num_dir d)
{
    return vec_of((struct num_point){num_length_of_unit(d.x), num_length_of_unit(d.y), num_length_of_unit(d.z)});
}

static void tell(const struct path *path, const struct tia_traced *traced)
{
#ifdef TIA_WATCHED
    if (path->observer->traced)
        path->observer->traced(path->observer->ctx, traced);
#else
    (void)path;
    (void)traced;
#endif
}

void observe_ray(const struct path *path, enum tia_ray kind, const struct ray *ray, const struct hit *hit,
                 const struct num_dir *normal)
{
    bool meets = hit->object != TIA_NO_OBJECT || hit->light != TIA_NO_OBJECT;
    num_length length = meets ? hit->t : NUM_LENGTH_ONE;
    struct tia_traced traced = {.ray = kind,
                                .from = vec_of(ray->origin),
                                .to = vec_of(num_point_at(ray->origin, ray->direction, length)),
                                .length = meets ? q16_of(hit->t) : INT32_MAX,
                                .object = hit->object,
                                .light = hit->light};

    if (normal)
        traced.normal = normal_of(*normal);
    tell(path, &traced);
}

void observe_shadow(const struct path *path, const struct observed_shadow *shadow)
{
    const struct ray_light *light = shadow->light;
    struct ray ray;
    num_length distance;

    if (!ray_light_shadow(light, shadow->sample, shadow->from, &ray, &distance))
        return;
    if (tia_light_has(light->kind, TIA_LIGHT_FAR))
        distance = NUM_LENGTH_ONE;
    struct tia_traced traced = {.ray = TIA_RAY_SHADOW,
                                .from = vec_of(ray.origin),
                                .to = vec_of(num_point_at(ray.origin, ray.direction, distance)),
                                .length = q16_of(distance),
                                .object = shadow->object,
                                .light = (uint32_t)(light - path->view->lights),
                                .normal = normal_of(shadow->normal),
                                .arrives = shadow->arrives};
    tell(path, &traced);
}
