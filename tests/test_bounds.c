/* tia_object_bounds: each shape against points of its surface, placed in double, which must lie inside and reach every
 * side; and boxes known by hand. */
#include <math.h>
#include <tia/bvh.h>

#include "check.h"
#include "random.h"

#define ONE 65536
#define STEPS 720

static const double pi = 3.14159265358979323846;

static struct tia_transform transform;
static struct tia_shape shape;
static struct tia_mesh mesh;
static struct tia_grid grid;

static double any(double least, double most)
{
    return least + (most - least) * (random_double() + 1) / 2;
}

static tia_q16 q16(double x)
{
    return (tia_q16)lrint(x * ONE);
}

static struct tia_vec3 any_point(double most)
{
    tia_q16 x = q16(any(-most, most)), y = q16(any(-most, most));
    return (struct tia_vec3){x, y, q16(any(-most, most))};
}

static struct tia_bounds bounds(bool placed)
{
    const struct tia_scene scene = {.shapes = &shape,
                                    .shape_count = 1,
                                    .transforms = &transform,
                                    .transform_count = 1,
                                    .meshes = &mesh,
                                    .mesh_count = 1,
                                    .grids = &grid,
                                    .grid_count = 1};
    shape.transform = placed;
    return tia_object_bounds(&scene, 0);
}

/* Extent of the points so far in the world, in units of 2^-16. */
static double least[3], most[3];

static void see_nothing(void)
{
    for (int k = 0; k < 3; k++) {
        least[k] = 1e30;
        most[k] = -1e30;
    }
}

static void see(double x, double y, double z)
{
    const tia_q16 turns[3] = {transform.rotation.x, transform.rotation.y, transform.rotation.z};
    const tia_q16 at[3] = {transform.position.x, transform.position.y, transform.position.z};
    double v[3] = {x, y, z};

    if (shape.transform) {
        v[0] *= transform.scale.x / 65536.0;
        v[1] *= transform.scale.y / 65536.0;
        v[2] *= transform.scale.z / 65536.0;
        for (int axis = 0; axis < 3; axis++) {
            double a = turns[axis] / 65536.0 * (pi / 180), *p = &v[(axis + 1) % 3], *q = &v[(axis + 2) % 3], p0 = *p;
            *p = cos(a) * p0 - sin(a) * *q;
            *q = sin(a) * p0 + cos(a) * *q;
        }
        for (int k = 0; k < 3; k++)
            v[k] += at[k];
    }
    for (int k = 0; k < 3; k++) {
        least[k] = v[k] < least[k] ? v[k] : least[k];
        most[k] = v[k] > most[k] ? v[k] : most[k];
    }
}

static void see_point(struct tia_vec3 p)
{
    see(p.x, p.y, p.z);
}

/* Gives two directions at right angles to n. */
static void across(const double n[3], double a[3], double b[3])
{
    int small = fabs(n[0]) < fabs(n[1]) ? (fabs(n[0]) < fabs(n[2]) ? 0 : 2) : fabs(n[1]) < fabs(n[2]) ? 1 : 2;
    double e[3] = {small == 0, small == 1, small == 2}, length = 0;

    for (int i = 0; i < 3; i++)
        a[i] = e[(i + 1) % 3] * n[(i + 2) % 3] - e[(i + 2) % 3] * n[(i + 1) % 3];
    for (int i = 0; i < 3; i++)
        length += a[i] * a[i];
    for (int i = 0; i < 3; i++)
        a[i] /= sqrt(length);
    length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (int i = 0; i < 3; i++)
        b[i] = (n[(i + 1) % 3] * a[(i + 2) % 3] - n[(i + 2) % 3] * a[(i + 1) % 3]) / length;
}

static void see_ring(const double c[3], double radius, const double n[3])
{
    double a[3], b[3];

    across(n, a, b);
    for (int i = 0; i < STEPS; i++) {
        double s = radius * sin(2 * pi * i / STEPS), t = radius * cos(2 * pi * i / STEPS);
        see(c[0] + s * a[0] + t * b[0], c[1] + s * a[1] + t * b[1], c[2] + s * a[2] + t * b[2]);
    }
}

static void see_circle(struct tia_vec3 c, double radius, const double n[3])
{
    see_ring((const double[]){c.x, c.y, c.z}, radius, n);
}

static void see_sphere(struct tia_vec3 c, double radius)
{
    const double up[3] = {0, 0, 1};
    for (int i = 0; i <= STEPS / 2; i++) {
        double a = pi * i / (STEPS / 2);
        see_ring((const double[]){c.x, c.y, c.z + radius * cos(a)}, radius * sin(a), up);
    }
}

static void see_box(struct tia_vec3 min, struct tia_vec3 max)
{
    for (int i = 0; i < 8; i++)
        see(i & 1 ? min.x : max.x, i & 2 ? min.y : max.y, i & 4 ? min.z : max.z);
}

/* Checks that all points are inside the box, and that it is larger than their extent by at most a unit of margin,
 * rounding, and `slack` times the extent, for points left out. */
static void check_tight(struct tia_bounds b, double slack)
{
    const tia_q16 min[3] = {b.min.x, b.min.y, b.min.z}, max[3] = {b.max.x, b.max.y, b.max.z};

    for (int k = 0; k < 3; k++) {
        double room = 3 + slack * (most[k] - least[k]) + 1e-9 * fabs(most[k]);
        CHECK_MSG(min[k] <= least[k] - 0.5 && max[k] >= most[k] + 0.5, "a point sticks out along axis %d", k);
        CHECK_MSG(min[k] >= least[k] - room && max[k] <= most[k] + room, "axis %d: %d..%d, not %.1f..%.1f", k,
                  (int)min[k], (int)max[k], least[k], most[k]);
    }
}

/* Slacks of curves of STEPS points: a circle's points miss its end by 1 - cos(pi/STEPS) of the radius, a sphere's in
 * two directions. */
#define CIRCLE 1e-5
#define SPHERE 4e-5

static void any_transform(void)
{
    transform.position = any_point(100);
    transform.rotation = any_point(720);
    transform.scale = (struct tia_vec3){q16(exp2(any(-3, 3))), q16(exp2(any(-3, 3))), q16(exp2(any(-3, 3)))};
}

TEST(spheres)
{
    for (int i = 0; i < 12; i++) {
        any_transform();
        shape = (struct tia_shape){.kind = TIA_SPHERE, .sphere = {any_point(50), q16(any(0.001, 20))}};
        struct tia_bounds b = bounds(i & 1);
        see_nothing();
        see_sphere(shape.sphere.centre, shape.sphere.radius);
        check_tight(b, SPHERE);
    }
}

TEST(discs)
{
    for (int i = 0; i < 200; i++) {
        any_transform();
        struct tia_dir3 n = {(tia_q30)any(-6e8, 6e8), (tia_q30)any(-6e8, 6e8), (tia_q30)any(-6e8, 6e8)};
        if (i < 60)
            n = (struct tia_dir3){i % 3 == 0 ? TIA_Q30_ONE : 0, i % 3 == 1 ? -TIA_Q30_ONE : 0,
                                  i % 3 == 2 ? TIA_Q30_ONE : (i & 16) * 10};
        shape = (struct tia_shape){.kind = TIA_DISC, .disc = {any_point(50), n, q16(any(0.001, 20))}};
        struct tia_bounds b = bounds(i & 1);
        see_nothing();
        see_circle(shape.disc.centre, shape.disc.radius, (const double[]){n.x, n.y, n.z});
        check_tight(b, CIRCLE);
    }
}

static void see_ends(struct tia_vec3 base, struct tia_vec3 top, double base_radius, double top_radius)
{
    const double n[3] = {(double)top.x - base.x, (double)top.y - base.y, (double)top.z - base.z};

    see_nothing();
    see_circle(base, base_radius, n);
    see_circle(top, top_radius, n);
}

TEST(cylinders_and_cones)
{
    for (int i = 0; i < 200; i++) {
        any_transform();
        struct tia_vec3 base = any_point(30), top = i & 2 ? base : any_point(30);
        tia_q16 r = q16(any(0.001, 20)), r2 = i & 4 ? 0 : q16(any(0.001, 20));
        if (i & 2)
            top.y += i & 8 ? 64 : -q16(10);
        shape = (struct tia_shape){.kind = TIA_CYLINDER, .cylinder = {base, top, r, true}};
        struct tia_bounds b = bounds(i & 1);
        see_ends(base, top, r, r);
        check_tight(b, CIRCLE);
        shape = (struct tia_shape){.kind = TIA_CONE, .cone = {base, top, r, r2, true}};
        b = bounds(i & 1);
        see_ends(base, top, r, r2);
        check_tight(b, CIRCLE);
    }
}

/* A torus touches its box where its circle does, a tube farther out; without a transform only, where the tube is
 * round. A point of the tube is seen at the nearest unit. */
TEST(tori)
{
    for (int i = 0; i < 100; i++) {
        any_transform();
        tia_q16 minor = q16(any(0.001, 5)), major = minor + 64 + q16(any(0.001, 20));
        struct tia_vec3 p = any_point(20);
        double n[3] = {any(-1, 1), any(-1, 1), any(-1, 1)}, a[3], b[3],
               size = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        struct tia_dir3 axis = {(tia_q30)(n[0] / size * 0x1p30), (tia_q30)(n[1] / size * 0x1p30),
                                (tia_q30)(n[2] / size * 0x1p30)};
        shape = (struct tia_shape){.kind = TIA_TORUS, .torus = {p, axis, major, minor}};
        struct tia_bounds box = bounds(i & 1);
        across(n, a, b);
        see_nothing();
        for (int k = 0; k < 400 * 200; k++) {
            double t = 2 * pi * (k % 400) / 400, s = 2 * pi * (k / 400) / 200, out = major + minor * cos(s);
            double x[3];
            for (int j = 0; j < 3; j++)
                x[j] = out * (cos(t) * a[j] + sin(t) * b[j]) + minor * sin(s) * n[j] / size;
            see(p.x + x[0], p.y + x[1], p.z + x[2]);
        }
        check_tight(box, 0.001);
    }
}

/* The hull of eight balls. */
TEST(rounded_boxes)
{
    for (int i = 0; i < 30; i++) {
        any_transform();
        tia_q16 r = q16(any(0.001, 3));
        struct tia_vec3 p = any_point(20), d = any_point(1);
        struct tia_vec3 q = {p.x + (d.x & 0xffff), p.y + (d.y & 0xffff), p.z + (d.z & 0xffff)};
        shape = (struct tia_shape){.kind = TIA_ROUNDED,
                                   .rounded = {{p.x - r, p.y - r, p.z - r}, {q.x + r, q.y + r, q.z + r}, r}};
        struct tia_bounds box = bounds(i & 1);
        see_nothing();
        for (int k = 0; k < 8; k++)
            see_sphere((struct tia_vec3){k & 1 ? q.x : p.x, k & 2 ? q.y : p.y, k & 4 ? q.z : p.z}, r);
        check_tight(box, 0.001);
    }
}

TEST(corners)
{
    static struct tia_vec3 vertices[30];
    static struct tia_face faces[10];

    for (int i = 0; i < 200; i++) {
        any_transform();
        struct tia_vec3 p = any_point(50), d = any_point(1);
        struct tia_vec3 max = {p.x + (d.x & 0xffff) + 1, p.y + (d.y & 0xffff) + 1, p.z + (d.z & 0xffff) + 1};
        shape = (struct tia_shape){.kind = TIA_BOX, .box = {p, max}};
        struct tia_bounds b = bounds(i & 1);
        see_nothing();
        see_box(p, max);
        check_tight(b, 0);

        shape = (struct tia_shape){.kind = TIA_TRIANGLE, .triangle = {{p, d, max}}};
        b = bounds(i & 1);
        see_nothing();
        see_point(p), see_point(d), see_point(max);
        check_tight(b, 0);

        shape = (struct tia_shape){.kind = TIA_GRID};
        grid = (struct tia_grid){p, (d.x & 0xffff) + 64, {1, 5, 300}, NULL};
        b = bounds(i & 1);
        see_nothing();
        see_box(p, (struct tia_vec3){p.x + grid.cell, p.y + 5 * grid.cell, p.z + 300 * grid.cell});
        check_tight(b, 0);

        shape = (struct tia_shape){.kind = TIA_MESH};
        mesh = (struct tia_mesh){.vertices = vertices, .faces = faces, .vertex_count = 30, .face_count = 10};
        struct tia_bounds own = {{INT32_MAX, INT32_MAX, INT32_MAX}, {INT32_MIN, INT32_MIN, INT32_MIN}};
#define KEEP(c)                                                                                                        \
    own.min.c = vertices[k].c < own.min.c ? vertices[k].c : own.min.c;                                                 \
    own.max.c = vertices[k].c > own.max.c ? vertices[k].c : own.max.c
        for (uint32_t k = 0; k < 30; k++) {
            vertices[k] = any_point(40);
            faces[k / 3].corner[k % 3].vertex = k;
            KEEP(x);
            KEEP(y);
            KEEP(z);
        }
        b = bounds(i & 1);
        see_nothing();
        see_box(own.min, own.max);
        check_tight(b, 0);
    }
}

static void check_box(struct tia_bounds b, struct tia_vec3 min, struct tia_vec3 max)
{
    CHECK_EQ(b.min.x, min.x);
    CHECK_EQ(b.min.y, min.y);
    CHECK_EQ(b.min.z, min.z);
    CHECK_EQ(b.max.x, max.x);
    CHECK_EQ(b.max.y, max.y);
    CHECK_EQ(b.max.z, max.z);
}

/* Bounds that need no rounding are exact but for the unit of margin, also with right angles and integer scales. */
TEST(exact)
{
    const struct tia_sphere sphere = {{1, -2, 3}, 100};
    const struct tia_scene scene = {.spheres = &sphere, .sphere_count = 1};

    check_box(tia_object_bounds(&scene, 0), (struct tia_vec3){-100, -103, -98}, (struct tia_vec3){102, 99, 104});
    transform = (struct tia_transform){{5, 6, 7}, {0, 0, 90 * ONE}, {2 * ONE, 3 * ONE, 4 * ONE}};
    shape = (struct tia_shape){.kind = TIA_SPHERE, .sphere = {{1000, 2000, 3000}, 100}};
    check_box(bounds(false), (struct tia_vec3){899, 1899, 2899}, (struct tia_vec3){1101, 2101, 3101});
    /* (2000, 6000, 12000) +- (200, 300, 400); a quarter about z takes (x, y) to (-y, x) */
    check_box(bounds(true), (struct tia_vec3){-6296, 1805, 11606}, (struct tia_vec3){-5694, 2207, 12408});
    shape = (struct tia_shape){.kind = TIA_DISC, .disc = {{0, 0, 0}, {0, TIA_Q30_ONE, 0}, 100}};
    check_box(bounds(false), (struct tia_vec3){-101, -1, -101}, (struct tia_vec3){101, 1, 101});
    shape = (struct tia_shape){.kind = TIA_CYLINDER, .cylinder = {{0, 0, 0}, {0, 0, 500}, 100, false}};
    check_box(bounds(false), (struct tia_vec3){-101, -101, -1}, (struct tia_vec3){101, 101, 501});
    shape = (struct tia_shape){.kind = TIA_SPHERE, .sphere = {{0, 0, 0}, INT32_MAX - 1}};
    check_box(bounds(false), (struct tia_vec3){-INT32_MAX, -INT32_MAX, -INT32_MAX},
              (struct tia_vec3){INT32_MAX, INT32_MAX, INT32_MAX});
}

static bool is_nothing(struct tia_bounds b)
{
    return b.max.x < b.min.x && b.max.y < b.min.y && b.max.z < b.min.z;
}

TEST(nothing)
{
    shape = (struct tia_shape){.kind = TIA_PLANE, .plane = {{0, 0, 0}, {0, TIA_Q30_ONE, 0}}};
    CHECK(is_nothing(bounds(false)));
    shape = (struct tia_shape){.kind = TIA_MESH};
    mesh = (struct tia_mesh){.face_count = 0};
    CHECK(is_nothing(bounds(false)));
    CHECK(is_nothing(bounds(true)));
}

TEST(beyond_the_numbers)
{
    transform = (struct tia_transform){{INT32_MAX, 0, INT32_MIN}, {0, 0, 0}, {1024 * ONE, ONE, 64}};
    shape = (struct tia_shape){.kind = TIA_SPHERE, .sphere = {{0, 0, 0}, 100 * ONE}};
    check_box(bounds(true), (struct tia_vec3){INT32_MIN, -100 * ONE - 1, INT32_MIN},
              (struct tia_vec3){INT32_MAX, 100 * ONE + 1, INT32_MIN + 6401});
}

int main(void)
{
    RUN(spheres);
    RUN(discs);
    RUN(cylinders_and_cones);
    RUN(tori);
    RUN(rounded_boxes);
    RUN(corners);
    RUN(exact);
    RUN(nothing);
    RUN(beyond_the_numbers);
    return check_status();
}
