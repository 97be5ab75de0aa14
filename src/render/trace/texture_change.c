/* texture_change.c - how far apart two places near a hit are in a texture. */
#include "render/geometry/round.h"
#include "render/geometry/triangle.h"
#include "texture.h"

static bool is_long(num_length x)
{
    return x > NUM_LENGTH_ONE || x < -NUM_LENGTH_ONE;
}

/* Halves a vector until no component is above 1. Returns the number of times. */
static int shorten(struct num_point *v)
{
    int times = 0;

    for (; is_long(v->x) || is_long(v->y) || is_long(v->z); times++)
        *v = (struct num_point){v->x / 2, v->y / 2, v->z / 2};
    return times;
}

/* Returns the change of a coordinate that goes round, 0 and 1 being one place. */
static num_length around(num_length x)
{
    return x > NUM_LENGTH_ONE / 2 ? x - NUM_LENGTH_ONE : x < -NUM_LENGTH_ONE / 2 ? x + NUM_LENGTH_ONE : x;
}

/* True if a coordinate goes round at the hit: u on spheres, and on the sides of cylinders and cones; both on tori. */
static bool is_round(const struct ray_view *view, const struct hit *hit, int axis)
{
    uint32_t element;
    const struct shape_kind *kind = ray_kind(view, hit, &element);
    bool has_sides = kind == &SHAPE_KIND(cylinder) || kind == &SHAPE_KIND(cone);
    bool u = kind == &SHAPE_KIND(sphere) || (has_sides && element == ROUND_SIDE);

    return kind == &SHAPE_KIND(torus) || (axis == 0 && u);
}

/* Gives the change of the surface coordinates, times 2^bits, between two places on a plane: of triangles and meshes,
 * whose coordinates end at their edges. False for other shapes. */
static bool change_on_flat(const struct ray_view *view, const struct hit *hit, struct num_point from,
                           struct num_point to, num_length uv[2], int *bits)
{
    uint32_t element;
    const struct shape_kind *kind = ray_kind(view, hit, &element);

    if (kind != &SHAPE_KIND(triangle) && kind != &SHAPE_KIND(mesh))
        return false;
    const struct shape *shape = &view->shapes[hit->object - view->scene->sphere_count];
    struct num_point own = num_point_sub(ray_own_point(view, hit, to), ray_own_point(view, hit, from));
    *bits += shorten(&own);
    if (kind == &SHAPE_KIND(mesh))
        mesh_uv_change(shape, element, own, uv);
    else
        triangle_uv_change(shape, element, own, uv);
    return true;
}

/* Gives the change of the place in a texture, times 2^bits. */
static void change_of_place(const struct ray_view *view, const struct tia_texture *t, const struct hit *hit,
                            struct num_point point, const struct texture_place *from, struct num_point change,
                            num_length d[3], int *bits)
{
    const struct num_point end = num_point_add(point, change);
    struct texture_place to;

    *bits += from->bits;
    if (t->kind != TIA_NOISE && change_on_flat(view, hit, point, end, d, bits))
        return;
    ray_texture_place(view, t, hit, end, &to);
    for (int i = 0; i < texture_axes(t); i++) {
        d[i] = to.at[i] - from->at[i];
        if (t->kind != TIA_NOISE && is_round(view, hit, i))
            d[i] = around(d[i]);
    }
}

void ray_texture_change(const struct ray_view *view, const struct tia_texture *t, const struct hit *hit,
                        struct num_point point, const struct texture_place *from, struct num_point change,
                        num_length cells[3])
{
    int bits = shorten(&change);
    num_length d[3];

    change_of_place(view, t, hit, point, from, change, d, &bits);
    cells[2] = 0;
    for (int i = 0; i < texture_axes(t); i++) {
        const struct num_pattern pattern = texture_pattern(t, i);
        cells[i] = num_repeats(d[i], bits, &pattern);
    }
}
