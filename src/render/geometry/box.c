/* box.c - axis-aligned boxes, by their slabs.
 *
 * A ray from outside enters the box where it enters the last of the slabs that it starts outside of, unless it has left
 * another slab before; a ray from inside leaves the box where it leaves the first slab. The planes ahead are found by
 * exact comparisons of coordinates. */
#include "box.h"

struct box_axis box_axis(num_length min, num_length max, num_length origin, num_unit direction)
{
    if (direction < 0)
        return (struct box_axis){origin - max, origin - min, -direction, true};
    return (struct box_axis){min - origin, max - origin, direction, false};
}

static uint32_t entered(const struct box_axis *axes, int i)
{
    return 2 * (uint32_t)i + axes[i].backward;
}

/* Returns the axis of the last slab that the ray enters, at *t; -1 if the ray starts within all slabs. A slab parallel
 * to the ray is not entered. */
static int enter(const struct box_axis axes[3], num_length *t)
{
    int last = -1;

    for (int i = 0; i < 3; i++) {
        if (axes[i].enter < 0 || axes[i].speed == 0)
            continue;
        num_length ti = num_div(axes[i].enter, axes[i].speed);
        if (last < 0 || ti > *t) {
            *t = ti;
            last = i;
        }
    }
    return last;
}

/* Returns the axis of the first slab that the ray leaves, at *t. */
static int leave(const struct box_axis axes[3], num_length *t)
{
    int first = -1;

    for (int i = 0; i < 3; i++) {
        num_length ti = num_div(axes[i].leave, axes[i].speed);
        if (axes[i].speed != 0 && (first < 0 || ti < *t)) {
            *t = ti;
            first = i;
        }
    }
    return first;
}

static bool is_passed(const struct box_axis *axis)
{
    return axis->leave < 0 || (axis->speed == 0 && axis->enter > 0);
}

static bool is_left(const struct box_axis *axis, num_length t)
{
    return num_times(t, axis->speed) > axis->leave;
}

struct box_axes {
    struct box_axis of[3];
};

static struct box_axes axes_of(const struct prepared_box *box, const struct ray *ray)
{
    return (struct box_axes){{box_axis(box->min.x, box->max.x, ray->origin.x, ray->direction.x),
                              box_axis(box->min.y, box->max.y, ray->origin.y, ray->direction.y),
                              box_axis(box->min.z, box->max.z, ray->origin.z, ray->direction.z)}};
}

static bool meet(const struct box_axis axes[3], num_length limit, struct intersection *intersection, bool *inside)
{
    num_length t = 0;

    if (is_passed(&axes[0]) || is_passed(&axes[1]) || is_passed(&axes[2]))
        return false;
    int axis = enter(axes, &t);
    *inside = axis < 0;
    if (*inside)
        axis = leave(axes, &t);
    if (t > limit || t >= NUM_LENGTH_MAX)
        return false;
    for (int i = 0; i < 3 && !*inside; i++)
        if (i != axis && is_left(&axes[i], t))
            return false;
    intersection->t = t;
    intersection->element = entered(axes, axis) ^ *inside;
    return true;
}

bool box_intersect(const struct prepared_box *box, const struct ray *ray, num_length limit,
                   struct intersection *intersection, bool *inside)
{
    const struct box_axes axes = axes_of(box, ray);

    return meet(axes.of, limit, intersection, inside);
}

void box_surface(uint32_t face, struct surface *surface)
{
    num_unit out = face & 1 ? NUM_UNIT_ONE : -NUM_UNIT_ONE;

    surface->normal = (struct num_dir){face / 2 == 0 ? out : 0, face / 2 == 1 ? out : 0, face / 2 == 2 ? out : 0};
    surface->smooth = surface->normal;
}

void box_uv(const struct prepared_box *box, struct num_point point, uint32_t face, num_length uv[2])
{
    struct num_point v = num_point_sub(point, box->min), size = num_point_sub(box->max, box->min);

    if (face == 1 || face == 3) /* U on face +x and V on face +y point along -z */
        v.z = size.z - v.z;
    if (face == 4) /* U on face -z points along -x */
        v.x = size.x - v.x;
    uv[0] = face / 2 == 0 ? num_ratio(v.z, size.z) : num_ratio(v.x, size.x);
    uv[1] = face / 2 == 1 ? num_ratio(v.z, size.z) : num_ratio(v.y, size.y);
}

static bool intersect(const struct shape *shape, const struct ray *ray, num_length limit,
                      struct intersection *intersection)
{
    bool inside;

    return box_intersect(&shape->box, ray, limit, intersection, &inside);
}

/* The exit of a ray that starts outside is at its entry or later, whatever the roundings. */
static bool chord_of(const struct shape *shape, const struct ray *ray, num_length after, struct chord *chord)
{
    const struct box_axes axes = axes_of(&shape->box, ray);
    bool inside;

    if (!meet(axes.of, NUM_LENGTH_MAX, &chord->enter, &inside))
        return false;
    chord->leave = chord->enter;
    if (inside) {
        chord->enter.t = -NUM_LENGTH_MAX;
    } else {
        num_length t = 0;
        int axis = leave(axes.of, &t);
        chord->leave.t = t > chord->enter.t ? t : chord->enter.t;
        chord->leave.element = entered(axes.of, axis) ^ 1;
    }
    return chord->leave.t > after;
}

static void surface_at(const struct shape *shape, struct num_point point, uint32_t element, struct surface *surface)
{
    (void)shape;
    (void)point;
    box_surface(element, surface);
}

static void uv_at(const struct shape *shape, struct num_point point, uint32_t element, num_length uv[2])
{
    box_uv(&shape->box, point, element, uv);
}

static void prepare(struct shape *shape, const struct tia_scene *scene, const struct tia_shape *given)
{
    (void)scene;
    shape->box = (struct prepared_box){num_point_of(given->box.min), num_point_of(given->box.max)};
}

const struct shape_kind SHAPE_KIND(box) = {prepare, intersect, shape_occludes, surface_at, uv_at, chord_of};
