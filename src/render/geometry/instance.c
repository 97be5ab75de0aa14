#include "instance.h"

#include "math/rotation.h"
#include "slab.h"

/* From Q47.16; |q| < 2^32. */
static num_x of_wide(int64_t q)
{
    return 2 * num_x_of((tia_q16)(q >> 1)) + num_x_of((tia_q16)(q & 1));
}

void placement_prepare(struct placement *placement, const struct tia_transform *transform,
                       const struct bounds_wide *bounds)
{
    const tia_q16 scale[3] = {transform->scale.x, transform->scale.y, transform->scale.z};
    int64_t axes[3][3];

    turn_axes(transform->rotation, axes);
    placement->position = num_point_of(transform->position);
    for (int i = 0; i < 3; i++) {
        placement->axes[i] = (struct num_dir){num_d_of62(axes[i][0]), num_d_of62(axes[i][1]), num_d_of62(axes[i][2])};
        placement->scale[i] = num_x_of(scale[i]);
        placement->min[i] = num_product(of_wide(bounds->min[i]), placement->scale[i]);
        placement->max[i] = num_product(of_wide(bounds->max[i]), placement->scale[i]);
    }
}

struct num_point placement_point(const struct placement *p, struct num_point point)
{
    struct num_point v = num_point_sub(point, p->position);

    return (struct num_point){num_ratio(num_dot_x(v, p->axes[0]), p->scale[0]),
                              num_ratio(num_dot_x(v, p->axes[1]), p->scale[1]),
                              num_ratio(num_dot_x(v, p->axes[2]), p->scale[2])};
}

/* Where the ray, whose direction is d along the axes, comes to the box. */
static num_x start_of(const struct placement *p, const struct ray *ray, struct num_dir d)
{
    const num_d along[3] = {d.x, d.y, d.z};
    struct num_point v = num_point_sub(ray->origin, p->position);
    num_x near = 0, far = num_slab_of(NUM_X_MOST);

    for (int i = 0; i < 3; i++) {
        struct slab slab = slab_of(num_dot_x(v, p->axes[i]), along[i]);
        slab_clip(&slab, p->min[i], p->max[i], &near, &far);
    }
    return near > far + NUM_SLAB_ERROR ? NUM_X_MOST + NUM_X_ONE : num_slab_start(near);
}

void placement_ray(const struct placement *p, const struct ray *ray, struct placed_ray *placed)
{
    struct num_dir d = {num_dot_d(ray->direction, p->axes[0]), num_dot_d(ray->direction, p->axes[1]),
                        num_dot_d(ray->direction, p->axes[2])};

    placed->start = start_of(p, ray, d);
    if (placed->start > NUM_X_MOST)
        return;
    placed->ray.origin = placement_point(p, num_point_at(ray->origin, ray->direction, placed->start));
    placed->scale = num_divide(d, p->scale, &placed->ray.direction);
}

num_x placement_distance(const struct placed_ray *placed, num_x t)
{
    return t < placed->start ? -1 : num_scaled(t - placed->start, placed->scale);
}

/* There and back is off by 2^-57 of t and by units of 2^-45, of which one in the world is k <= 2^10 in the shape's
 * axes: 2^-40 k and as much again. */
num_x placement_limit(const struct placed_ray *placed, num_x t)
{
    num_x more = t / (num_x)(INT64_C(1) << 40) + NUM_X_BIAS / (1 << 27);

    if (t < placed->start)
        return -1;
    num_x limit = num_scaled(t - placed->start + more, placed->scale) + more;
    return limit < NUM_X_MOST ? limit : NUM_X_MOST;
}

num_x placement_distance_back(const struct placed_ray *placed, num_x t)
{
    return placed->start + num_unscaled(t, placed->scale);
}

/* By the inverse transpose: n_i / s_i along the axes. */
struct num_dir placement_normal(const struct placement *p, struct num_dir normal)
{
    struct num_dir n;

    (void)num_divide(normal, p->scale, &n);
    return num_dir_unit(num_dir_add(num_dir_add(num_dir_scaled(p->axes[0], n.x), num_dir_scaled(p->axes[1], n.y)),
                                    num_dir_scaled(p->axes[2], n.z)));
}
