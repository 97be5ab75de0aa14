#include "placement.h"

#include "turn.h"

static num_x largest(num_x a, num_x b)
{
    return a > b ? a : b;
}

void placement_prepare(struct placement *placement, const struct tia_transform *transform, struct tia_bounds bounds)
{
    num_x scale[3] = {num_x_of(transform->scale.x), num_x_of(transform->scale.y), num_x_of(transform->scale.z)};
    int64_t axes[3][3];

    turn_axes(transform->rotation, axes);
    placement->position = num_point_of(transform->position);
    placement->least = scale[0] < scale[1] ? scale[0] : scale[1];
    placement->least = scale[2] < placement->least ? scale[2] : placement->least;
    for (int i = 0; i < 3; i++) {
        placement->axes[i] = (struct num_dir){num_d_of62(axes[i][0]), num_d_of62(axes[i][1]), num_d_of62(axes[i][2])};
        placement->ratio[i] = num_fraction(placement->least, scale[i]);
    }
    struct num_point min = num_point_of(bounds.min), max = num_point_of(bounds.max);
    struct num_point half = {(max.x - min.x) / 2, (max.y - min.y) / 2, (max.z - min.z) / 2};
    placement->centre = num_point_add(min, half);
    placement->radius = largest(num_length(half), NUM_X_BIAS);
}

/* The components along the axes, times m/s. */
static struct num_point into_axes(const struct placement *p, struct num_point v)
{
    return (struct num_point){num_times(num_dot_x(v, p->axes[0]), p->ratio[0]),
                              num_times(num_dot_x(v, p->axes[1]), p->ratio[1]),
                              num_times(num_dot_x(v, p->axes[2]), p->ratio[2])};
}

struct num_point placement_point(const struct placement *p, struct num_point point)
{
    struct num_point v = into_axes(p, num_point_sub(point, p->position));

    return (struct num_point){num_ratio(v.x, p->least), num_ratio(v.y, p->least), num_ratio(v.z, p->least)};
}

void placement_ray(const struct placement *p, const struct ray *ray, struct placed_ray *placed)
{
    num_x nearest = num_dot_x(num_point_sub(p->centre, ray->origin), ray->direction);
    struct num_dir d = {num_times(num_dot_d(ray->direction, p->axes[0]), p->ratio[0]),
                        num_times(num_dot_d(ray->direction, p->axes[1]), p->ratio[1]),
                        num_times(num_dot_d(ray->direction, p->axes[2]), p->ratio[2])};

    placed->start = nearest > p->radius ? nearest - p->radius : 0;
    placed->ray.origin = placement_point(p, num_point_at(ray->origin, ray->direction, placed->start));
    placed->ray.direction = num_dir_unit(d);
    placed->shrink = num_dot_d(d, placed->ray.direction);
}

num_x placement_distance(const struct placement *p, const struct placed_ray *placed, num_x t)
{
    if (t < placed->start)
        return -1;
    return num_ratio(num_times(t - placed->start, placed->shrink), p->least);
}

num_x placement_distance_back(const struct placement *p, const struct placed_ray *placed, num_x t)
{
    return placed->start + num_over(num_product(t, p->least), placed->shrink);
}

struct num_dir placement_normal(const struct placement *p, struct num_dir n)
{
    struct num_dir x = num_dir_scaled(p->axes[0], num_times(n.x, p->ratio[0]));
    struct num_dir y = num_dir_scaled(p->axes[1], num_times(n.y, p->ratio[1]));
    struct num_dir z = num_dir_scaled(p->axes[2], num_times(n.z, p->ratio[2]));

    return num_dir_unit(num_dir_add(num_dir_add(x, y), z));
}
