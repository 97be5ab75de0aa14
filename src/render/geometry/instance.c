#include "instance.h"

#include "math/rotation.h"
#include "slab.h"

/* Converts from Q47.16; |q| < 2^32. */
static num_length of_wide(int64_t q)
{
    return 2 * num_length_of((tia_q16)(q >> 1)) + num_length_of((tia_q16)(q & 1));
}

void instance_prepare(struct instance *instance, const struct tia_transform *transform,
                      const struct bounds_wide *bounds)
{
    const tia_q16 scale[3] = {transform->scale.x, transform->scale.y, transform->scale.z};
    int64_t axes[3][3];

    tia_rotation_axes(transform->rotation, axes);
    instance->position = num_point_of(transform->position);
    for (int i = 0; i < 3; i++) {
        instance->axes[i] =
            (struct num_dir){num_unit_of_q62(axes[i][0]), num_unit_of_q62(axes[i][1]), num_unit_of_q62(axes[i][2])};
        instance->scale[i] = num_length_of(scale[i]);
        instance->min[i] = num_product(of_wide(bounds->min[i]), instance->scale[i]);
        instance->max[i] = num_product(of_wide(bounds->max[i]), instance->scale[i]);
    }
}

struct num_point instance_point(const struct instance *p, struct num_point point)
{
    struct num_point v = num_point_sub(point, p->position);

    return (struct num_point){num_ratio(num_point_dot(v, p->axes[0]), p->scale[0]),
                              num_ratio(num_point_dot(v, p->axes[1]), p->scale[1]),
                              num_ratio(num_point_dot(v, p->axes[2]), p->scale[2])};
}

/* Returns the t at which the ray reaches the box; above NUM_LENGTH_MAX if it misses the box. d is the direction along
 * the instance's axes. */
static num_length start_of(const struct instance *p, const struct ray *ray, struct num_dir d)
{
    const num_unit along[3] = {d.x, d.y, d.z};
    struct num_point v = num_point_sub(ray->origin, p->position);
    num_length near = 0, far = num_slab_of(NUM_LENGTH_MAX);

    for (int i = 0; i < 3; i++) {
        struct slab slab = slab_of(num_point_dot(v, p->axes[i]), along[i]);
        slab_clip(&slab, p->min[i], p->max[i], &near, &far);
    }
    return near > far + NUM_SLAB_ERROR ? NUM_LENGTH_MAX + NUM_LENGTH_ONE : num_slab_start(near);
}

void instance_transform_ray(const struct instance *p, const struct ray *ray, struct instance_ray *placed)
{
    struct num_dir d = {num_dir_dot(ray->direction, p->axes[0]), num_dir_dot(ray->direction, p->axes[1]),
                        num_dir_dot(ray->direction, p->axes[2])};

    placed->start = start_of(p, ray, d);
    if (placed->start > NUM_LENGTH_MAX)
        return;
    placed->ray.origin = instance_point(p, num_point_at(ray->origin, ray->direction, placed->start));
    placed->scale = num_divide(d, p->scale, &placed->ray.direction);
    ray_watch_as(&placed->ray, ray);
}

num_length instance_distance(const struct instance_ray *placed, num_length t)
{
    return t < placed->start ? -1 : num_scaled(t - placed->start, placed->scale);
}

/* Returns the limit in the shape's axes, with a margin. Converting t to these axes and back has an error of 2^-57 t and
 * some units of 2^-45, and a unit in the world is k <= 2^10 units in the shape's axes. The margin is k m + m, where m =
 * 2^-40 (t + 1). */
num_length instance_limit(const struct instance_ray *placed, num_length t)
{
    num_length more = t / (num_length)(INT64_C(1) << 40) + NUM_LENGTH_BIAS / (num_length)(INT32_C(1) << 27);

    if (t < placed->start)
        return -1;
    num_length limit = num_scaled(t - placed->start + more, placed->scale) + more;
    return limit < NUM_LENGTH_MAX ? limit : NUM_LENGTH_MAX;
}

num_length instance_distance_back(const struct instance_ray *placed, num_length t)
{
    return placed->start + num_unscaled(t, placed->scale);
}

/* Transforms a normal by the inverse transpose: n_i / s_i along the axes. */
struct num_dir instance_normal(const struct instance *p, struct num_dir normal)
{
    struct num_dir n;

    (void)num_divide(normal, p->scale, &n);
    return num_dir_normalised(num_dir_add(num_dir_add(num_dir_scaled(p->axes[0], n.x), num_dir_scaled(p->axes[1], n.y)),
                                          num_dir_scaled(p->axes[2], n.z)));
}
