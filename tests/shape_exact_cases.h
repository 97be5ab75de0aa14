/* shape_exact_cases.h - rays whose exact result is known and does not depend on rounding: along the axes, through
 * apices and edges, from surfaces. */
#include "shape_check.h"

enum { NOTHING = 99 };

/* Returns the element that a ray meets, with the distance in *t. The ray starts at (x, y, z) and runs along axis 0 to
 * 2, forwards if `way` is 1, backwards if it is -1. */
static uint32_t meets(const struct shape *shape, double x, double y, double z, int axis, int way, double *t)
{
    num_unit d[3] = {0, 0, 0};
    struct intersection c;

    d[axis] = way < 0 ? -NUM_UNIT_ONE : NUM_UNIT_ONE;
    struct ray ray = {{x_of(x), x_of(y), x_of(z)}, {d[0], d[1], d[2]}};
    if (!shape->kind->intersect(shape, &ray, NUM_LENGTH_MAX, &c))
        return NOTHING;
    *t = (double)real_x(c.t);
    return c.element;
}

#define CHECK_MEETS(shape, x, y, z, axis, way, element, distance)                                                      \
    do {                                                                                                               \
        double met_t = 0;                                                                                              \
        CHECK_EQ(meets(shape, x, y, z, axis, way, &met_t), element);                                                   \
        CHECK_MSG(fabs(met_t - (distance)) < 1e-12, "at %g, not %g", met_t, (double)(distance));                       \
    } while (0)

#define CHECK_MISSES(shape, x, y, z, axis, way)                                                                        \
    do {                                                                                                               \
        double met_t;                                                                                                  \
        CHECK_EQ(meets(shape, x, y, z, axis, way, &met_t), NOTHING);                                                   \
    } while (0)

TEST(cylinders_along_the_axes)
{
    struct tia_cylinder cylinder = {{0, 0, 0}, TIA_VEC3(0, 2, 0), TIA_Q16(1), true};
    struct shape s;

    PREPARE(&s, TIA_CYLINDER, cylinder, cylinder);
    for (int k = 0; k < 2; k++) { /* on the axis and beside it */
        double x = k * 0.5;
        CHECK_MEETS(&s, x, 5, 0, 1, -1, 2, 3);
        CHECK_MEETS(&s, x, 1, 0, 1, -1, 1, 1);
        CHECK_MEETS(&s, x, 1, 0, 1, 1, 2, 1);
        CHECK_MISSES(&s, x, -1, 0, 1, -1);
    }
    CHECK_MISSES(&s, 0, 5, 1 + 0x1p-16, 1, -1);
    CHECK_MEETS(&s, -5, 1, 0, 0, 1, 0, 4);
    CHECK_MEETS(&s, 0, 1, 0, 0, 1, 0, 1);
    CHECK_MEETS(&s, -5, 0, 0, 0, 1, 0, 4); /* in the plane of the base */
    CHECK_MEETS(&s, 0, 0, 0, 0, 1, 0, 1);
    CHECK_MEETS(&s, 0, 2, 0, 2, -1, 0, 1);
    CHECK_MISSES(&s, -5, -0x1p-16, 0, 0, 1);
    CHECK_MISSES(&s, -5, 2 + 0x1p-16, 0, 0, 1);
    CHECK_MISSES(&s, -5, 1, 1 + 0x1p-16, 0, 1);
    cylinder.capped = false;
    PREPARE(&s, TIA_CYLINDER, cylinder, cylinder);
    CHECK_MISSES(&s, 0, 5, 0, 1, -1);
    CHECK_MISSES(&s, 0.5, 1, 0, 1, 1);
    CHECK_MEETS(&s, 0, 0, 0, 0, 1, 0, 1);
}

/* A cone, and the same cone turned upside down. */
TEST(cones_along_the_axes)
{
    for (int capped = 0; capped < 2; capped++) {
        for (int way = -1; way <= 1; way += 2) {
            const struct tia_vec3 foot = {0, 0, 0}, peak = {0, way * TIA_Q16(2), 0};
            const struct tia_cone turned[2] = {{foot, peak, TIA_Q16(1), 0, capped},
                                               {peak, foot, 0, TIA_Q16(1), capped}};
            for (uint32_t k = 0; k < 2; k++) {
                uint32_t cap = capped ? 1 + k : 0;
                struct surface surface;
                struct shape s;
                PREPARE(&s, TIA_CONE, cone, turned[k]);
                CHECK_MEETS(&s, 0, way * 5, 0, 1, -way, 0, 3); /* the apex */
                CHECK_MEETS(&s, 0, way * -5, 0, 1, way, cap, capped ? 5 : 7);
                CHECK_MEETS(&s, 0, way * 1, 0, 1, way, 0, 1);
                CHECK_MEETS(&s, 0.25, way * 5, 0, 1, -way, 0, 3.5);
                CHECK_MEETS(&s, -5, way * 1, 0, 0, 1, 0, 4.5);
                CHECK_MEETS(&s, 0, way * 1, 0, 2, 1, 0, 0.5);
                CHECK_MISSES(&s, -5, way * 3, 0, 0, 1); /* the other half of the double cone */
                CHECK_MISSES(&s, 0, way * 3, 0, 1, way);
                s.kind->surface(&s, num_point_of(peak), 0, &surface);
                CHECK(size(real_d(surface.normal.y) - way) < (real)1e-15);
            }
        }
    }
}

static void check_uv(const struct shape *s, double x, double y, double z, uint32_t element, double u, double v)
{
    num_length uv[2];

    s->kind->uv(s, (struct num_point){x_of(x), x_of(y), x_of(z)}, element, uv);
    CHECK_MSG(fabs((double)real_x(uv[0]) - u) < 1e-14, "u is %g, not %g", (double)real_x(uv[0]), u);
    CHECK_MSG(fabs((double)real_x(uv[1]) - v) < 1e-14, "v is %g, not %g", (double)real_x(uv[1]), v);
}

/* Along y, U is x and V is -z; along x, U is -z and V is y. */
TEST(surface_coordinates)
{
    struct shape s;

    PREPARE(&s, TIA_CYLINDER, cylinder, {{0, 0, 0}, TIA_VEC3(0, 4, 0), TIA_Q16(2), true});
    check_uv(&s, 2, 1, 0, 0, 0.5, 0.25);
    check_uv(&s, 0, 4, 2, 0, 0.25, 1);
    check_uv(&s, 0, 0, -2, 0, 0.75, 0);
    check_uv(&s, 1, 0, 0.5, 1, 0.75, 0.625);
    check_uv(&s, 1, 4, -0.5, 2, 0.75, 0.625);
    PREPARE(&s, TIA_CYLINDER, cylinder, {{0, 0, 0}, TIA_VEC3(4, 0, 0), TIA_Q16(2), true});
    check_uv(&s, 1, 2, 0, 0, 0.75, 0.25);
    check_uv(&s, 0, 1, 0.5, 1, 0.625, 0.75);
    check_uv(&s, 4, 1, 0.5, 2, 0.375, 0.75);
    PREPARE(&s, TIA_DISC, disc, {TIA_VEC3(1, 0, 0), {0, TIA_Q30(1), 0}, TIA_Q16(4)});
    check_uv(&s, 2, 0, 3, 0, 0.625, 0.125);
    PREPARE(&s, TIA_PLANE, plane, {TIA_VEC3(1, 0, 0), {0, TIA_Q30(1), 0}});
    check_uv(&s, 2, 0, -3, 0, 1, 3);
    PREPARE(&s, TIA_BOX, box, {{0, 0, 0}, TIA_VEC3(2, 4, 8)});
    check_uv(&s, 0, 1, 2, 0, 0.25, 0.25);
    check_uv(&s, 2, 1, 2, 1, 0.75, 0.25);
    check_uv(&s, 0.5, 0, 2, 2, 0.25, 0.25);
    check_uv(&s, 1, 4, 2, 3, 0.5, 0.75);
    check_uv(&s, 0.5, 1, 0, 4, 0.75, 0.25);
    check_uv(&s, 0.5, 1, 8, 5, 0.25, 0.25);
}

TEST(boxes_along_the_axes)
{
    struct shape s;

    PREPARE(&s, TIA_BOX, box, {{0, 0, 0}, TIA_VEC3(2, 4, 8)});
    CHECK_MEETS(&s, -3, 1, 1, 0, 1, 0, 3);
    CHECK_MEETS(&s, 1, 1, 1, 0, 1, 1, 1);
    CHECK_MEETS(&s, 1, 9, 1, 1, -1, 3, 5);
    CHECK_MEETS(&s, 1, 1, 9, 2, -1, 5, 1);
    CHECK_MEETS(&s, 0, 1, 1, 0, 1, 0, 0); /* a ray that starts on a face hits it there, in whichever direction it
                                             goes */
    CHECK_MEETS(&s, 0, 1, 1, 0, -1, 0, 0);
    CHECK_MEETS(&s, 0, 1, 1, 1, 1, 3, 3); /* along a face */
    CHECK_MEETS(&s, 2, -1, 1, 1, 1, 2, 1);
    CHECK_MISSES(&s, 2 + 0x1p-40, -1, 1, 1, 1);
    CHECK_MISSES(&s, 1, 5, 1, 1, 1);
}

/* Cells 1 0 2 1 in a row along x. Rays start in front of the grid, and on the planes where the content changes. */
TEST(grids_along_the_axes)
{
    static const uint8_t cells[] = {1, 0, 2, 1};
    const struct tia_grid grid = {{0, 0, 0}, TIA_Q16(1), {4, 1, 1}, cells};
    struct shape s;

    prepare_grid_alone(&s, &grid);
    CHECK_MEETS(&s, -1, 0.5, 0.5, 0, 1, 0, 1);
    CHECK_MEETS(&s, 0, 0.5, 0.5, 0, 1, 0, 0);
    CHECK_MEETS(&s, 0.5, 0.5, 0.5, 0, 1, 1, 0.5);
    CHECK_MEETS(&s, 1, 0.5, 0.5, 0, 1, 1, 0);
    CHECK_MEETS(&s, 1, 0.5, 0.5, 0, -1, 1, 0);
    CHECK_MEETS(&s, 1.5, 0.5, 0.5, 0, 1, 12, 0.5);
    CHECK_MEETS(&s, 2.5, 0.5, 0.5, 0, 1, 18, 0.5);
    CHECK_MEETS(&s, 3.5, 0.5, 0.5, 0, 1, 19, 0.5);
    CHECK_MEETS(&s, 3.5, 0.5, 0.5, 0, -1, 13, 0.5);
    CHECK_MEETS(&s, 2.5, 0.5, 0.5, 0, -1, 12, 0.5);
    CHECK_MEETS(&s, 1.5, 0.5, 0.5, 0, -1, 1, 0.5);
    CHECK_MEETS(&s, 2.5, 0.5, 0.5, 1, 1, 15, 0.5);
    CHECK_MISSES(&s, 1.5, 5, 0.5, 1, -1);
    CHECK_MISSES(&s, 4.5, 0.5, 0.5, 0, 1);
}
