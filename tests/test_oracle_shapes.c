/* The oracle's shapes against points, normals and surface coordinates worked out by hand. */
#include "check.h"
#include "oracle/shape.h"

#define NEAR(got, want)                                                                                                \
    CHECK_MSG(fabs((got) - (want)) < 1e-9, "%s is %.17g, not %.17g", #got, (double)(got), (double)(want))
#define NEAR_VEC(got, ...)                                                                                             \
    do {                                                                                                               \
        struct oracle_vec near_want = {__VA_ARGS__};                                                                   \
        CHECK_MSG(length(sub(got, near_want)) < 1e-9, "%s is %.9g %.9g %.9g", #got, (got).x, (got).y, (got).z);        \
    } while (0)

static struct tia_transform transforms[1];
static struct tia_mesh meshes[1];
static struct tia_grid grids[1];

static bool meets(const struct tia_shape *shape, struct ray ray, struct hit *hit)
{
    struct tia_scene scene = {.shapes = shape,
                              .transforms = transforms,
                              .meshes = meshes,
                              .grids = grids,
                              .shape_count = 1,
                              .transform_count = 1};

    return object_hit(&scene, 0, ray, hit);
}

static struct ray ray(double ox, double oy, double oz, double dx, double dy, double dz)
{
    return (struct ray){{ox, oy, oz}, unit((struct oracle_vec){dx, dy, dz})};
}

/* The plane is y = -2. With N = y: U = x, V = -z, also seen from below, as the normal does not turn. */
TEST(plane)
{
    struct tia_shape s = {.kind = TIA_PLANE, .plane = {TIA_VEC3(1, -2, 0), {0, TIA_Q30(1.25), 0}}};
    struct hit h;

    CHECK(meets(&s, ray(0, 0, 0, 3, -2, 6), &h));
    NEAR(h.t, 7);
    NEAR_VEC(h.normal, 0, 1, 0);
    NEAR(h.u, 2);
    NEAR(h.v, -6);
    CHECK(meets(&s, ray(0, -4, 0, 0, 1, 0), &h));
    NEAR(h.t, 2);
    NEAR_VEC(h.normal, 0, 1, 0);
    CHECK(!meets(&s, ray(0, 0, 0, 0, 1, -1), &h));
    CHECK(!meets(&s, ray(0, 0, 0, 1, 0, 0), &h));
}

/* The e of light.h is the first of the coordinates nearest to 0: for N = x it is y, A = y x x = -z, B = x x -z = y; for
 * N along (-2, -3, 1) it is z. */
TEST(axes_of_a_normal)
{
    struct oracle_vec a, b;

    axes((struct oracle_vec){1, 0, 0}, &a, &b);
    NEAR_VEC(a, 0, 0, -1);
    NEAR_VEC(b, 0, 1, 0);
    axes(unit((struct oracle_vec){-2, -3, 1}), &a, &b);
    NEAR_VEC(a, 3 / sqrt(13), -2 / sqrt(13), 0); /* z x N */
    NEAR(dot(b, unit((struct oracle_vec){-2, -3, 1})), 0);
    NEAR(cross(a, b).z, 1 / sqrt(14));
}

TEST(points_farther_than_65536_are_not_met)
{
    struct tia_shape s = {.kind = TIA_PLANE, .plane = {TIA_VEC3(0, -1, 0), {0, TIA_Q30(1), 0}}};
    struct hit h;

    CHECK(meets(&s, ray(0, 0, 0, 0, -1, -65535.0), &h));
    CHECK(!meets(&s, ray(0, 0, 0, 0, -1, -65537.0), &h));
    CHECK(!meets(&s, ray(0, 0, 0, 65537.0, -1, 0), &h));
}

/* With N = z: U = y x z = x, V = z x x = y, 2 on each side of the centre. */
TEST(disc)
{
    struct tia_shape s = {.kind = TIA_DISC, .disc = {TIA_VEC3(1, 0, -4), {0, 0, TIA_Q30(1)}, TIA_Q16(2)}};
    struct hit h;

    CHECK(meets(&s, ray(2, 1, 0, 0, 0, -1), &h));
    NEAR(h.t, 4);
    NEAR(h.u, 0.75);
    NEAR(h.v, 0.75);
    CHECK(meets(&s, ray(2.99, 0, 0, 0, 0, -1), &h));
    CHECK(!meets(&s, ray(3.01, 0, 0, 0, 0, -1), &h));
}

/* The point at (3, 0, 4)/5 r from the centre has 1/2 - atan2(4, 3)/(2 pi), 1 - acos(0)/pi. */
TEST(sphere)
{
    struct tia_shape s = {.kind = TIA_SPHERE, .sphere = {TIA_VEC3(0, 0, -10), TIA_Q16(5)}};
    struct hit h;

    CHECK(meets(&s, ray(3, 0, 0, 0, 0, -1), &h));
    NEAR(h.t, 6);
    NEAR_VEC(h.normal, 0.6, 0, 0.8);
    NEAR(h.u, 0.5 - atan2(4, 3) / (2 * PI));
    NEAR(h.v, 0.5);
    CHECK(meets(&s, ray(0, 3, 0, 0, 0, -1), &h));
    NEAR(h.v, 1 - acos(0.6) / PI);
    CHECK(!meets(&s, ray(0, 0, 0, 0, 0, 1), &h));
    CHECK(meets(&s, ray(0, 0, -9, 0, 0, -1), &h)); /* from inside, towards the centre */
    NEAR(h.t, 6);
    CHECK(meets(&s, ray(0, 0, -9, 0, 0, 1), &h)); /* and away from it */
    NEAR(h.t, 4);
    NEAR_VEC(h.normal, 0, 0, 1);
}

/* The axis is y from 0 to 4: U = x, V = -z as for the plane; u = 1/2 - atan2(z, x)/(2 pi), as on a sphere. */
TEST(cylinder)
{
    struct tia_shape s = {.kind = TIA_CYLINDER, .cylinder = {TIA_VEC3(0, 0, 0), TIA_VEC3(0, 4, 0), TIA_Q16(2), false}};
    struct hit h;

    CHECK(meets(&s, ray(0, 1, 10, 0, 0, -1), &h));
    NEAR(h.t, 8);
    NEAR_VEC(h.normal, 0, 0, 1);
    NEAR(h.u, 0.25);
    NEAR(h.v, 0.25);
    CHECK(meets(&s, ray(1, 1, 0, 1, 0, 0), &h)); /* from inside */
    NEAR(h.t, 1);
    NEAR_VEC(h.normal, 1, 0, 0);
    CHECK(!meets(&s, ray(0, 4.01, 10, 0, 0, -1), &h));
    CHECK(meets(&s, ray(0, 5, 3.5, 0, -1, -2), &h)); /* through the open top onto the far side */
    NEAR(h.t, 2.75 * sqrt(5));
    NEAR_VEC(h.normal, 0, 0, -1);
    CHECK(!meets(&s, ray(1, 5, 0, 0, -1, 0), &h));
}

TEST(caps)
{
    struct tia_shape s = {.kind = TIA_CYLINDER, .cylinder = {TIA_VEC3(0, 0, 0), TIA_VEC3(0, 4, 0), TIA_Q16(2), true}};
    struct hit h;

    CHECK(meets(&s, ray(1, 6, -1, 0, -1, 0), &h));
    NEAR(h.t, 2);
    NEAR_VEC(h.normal, 0, 1, 0);
    NEAR(h.u, 0.75); /* (x, -z) */
    NEAR(h.v, 0.75);
    CHECK(meets(&s, ray(1, -6, -1, 0, 1, 0), &h));
    NEAR(h.t, 6);
    NEAR_VEC(h.normal, 0, -1, 0);
    NEAR(h.u, 0.75); /* (x, z) */
    NEAR(h.v, 0.25);
    CHECK(meets(&s, ray(0, 1, 0, 0, 1, 0), &h)); /* from inside */
    NEAR(h.t, 3);
    CHECK_EQ(h.part, 2);
}

/* The cone x^2 + z^2 = (1 - y)^2 has a side that falls at 45 degrees. */
TEST(cone)
{
    struct tia_shape s = {.kind = TIA_CONE,
                          .cone = {TIA_VEC3(0, 0, 0), TIA_VEC3(0, 1, 0), TIA_Q16(1), TIA_Q16(0), false}};
    struct hit h;

    CHECK(meets(&s, ray(5, 0.5, 0, -1, 0, 0), &h));
    NEAR(h.t, 4.5);
    NEAR_VEC(h.normal, sqrt(0.5), sqrt(0.5), 0);
    NEAR(h.u, 0.5);
    NEAR(h.v, 0.5);
    CHECK(!meets(&s, ray(5, 1.5, 0, -1, 0, 0), &h)); /* no second cone beyond the apex */
    CHECK(meets(&s, ray(0.25, 5, 0, 0, -1, 0), &h)); /* parallel to the axis */
    NEAR(h.t, 4.25);
    CHECK(meets(&s, ray(0.5, -1, 0, 0, 1, 0), &h)); /* from below onto the inside */
    NEAR(h.t, 1.5);
    CHECK(meets(&s, ray(2, 0, 0, -1, 0.25, 0), &h)); /* 2 - s = 1 - s/4 */
    NEAR(h.t, 4 / 3.0 * sqrt(1 + 1 / 16.0));
    s.cone.capped = true;
    CHECK(meets(&s, ray(0.5, -1, 0, 0, 1, 0), &h));
    NEAR(h.t, 1);
    NEAR_VEC(h.normal, 0, -1, 0);
    NEAR(h.v, 0.5);
    CHECK_EQ(h.part, 1);
}

/* A ray parallel to the far side of the cone makes the quadratic's first coefficient 0. */
TEST(cone_along_its_side)
{
    struct tia_shape s = {.kind = TIA_CONE,
                          .cone = {TIA_VEC3(0, 0, 0), TIA_VEC3(0, 1, 0), TIA_Q16(0), TIA_Q16(1), false}};
    struct hit h;

    CHECK(meets(&s, ray(1, 0, 0, -1, 1, 0), &h)); /* x = 1 - y meets x = y */
    NEAR(h.t, sqrt(0.5));
    NEAR_VEC(h.normal, sqrt(0.5), -sqrt(0.5), 0);
}

TEST(box)
{
    struct tia_shape s = {.kind = TIA_BOX, .box = {TIA_VEC3(-1, 0, -4), TIA_VEC3(3, 2, -2)}};
    struct hit h;

    CHECK(meets(&s, ray(0, 0.5, 0, 0, 0, -1), &h));
    NEAR(h.t, 2);
    NEAR_VEC(h.normal, 0, 0, 1);
    NEAR(h.u, 0.25); /* (x, y) */
    NEAR(h.v, 0.25);
    CHECK(meets(&s, ray(0, 9, -2.5, 0, -1, 0), &h));
    NEAR_VEC(h.normal, 0, 1, 0);
    NEAR(h.u, 0.25); /* (x, -z) */
    NEAR(h.v, 0.25);
    CHECK_EQ(h.part, 3);
    CHECK(meets(&s, ray(-9, 0.5, -2.5, 1, 0, 0), &h));
    NEAR_VEC(h.normal, -1, 0, 0);
    NEAR(h.u, 0.75); /* (z, y) */
    NEAR(h.v, 0.25);
    CHECK_EQ(h.part, 0);
    CHECK(meets(&s, ray(0, 1, -3, 1, 0, 0), &h)); /* from inside */
    NEAR(h.t, 3);
    NEAR_VEC(h.normal, 1, 0, 0);
    CHECK(!meets(&s, ray(0, 2.01, 0, 0, 0, -1), &h));
}

TEST(triangle)
{
    struct tia_shape s = {.kind = TIA_TRIANGLE,
                          .triangle = {{TIA_VEC3(0, 0, -2), TIA_VEC3(4, 0, -2), TIA_VEC3(0, 2, -2)}}};
    struct hit h;

    CHECK(meets(&s, ray(1, 1, 0, 0, 0, -1), &h));
    NEAR(h.t, 2);
    NEAR_VEC(h.normal, 0, 0, 1);
    NEAR(h.u, 0.25);
    NEAR(h.v, 0.5);
    CHECK(meets(&s, ray(1, 1, -5, 0, 0, 1), &h));
    NEAR_VEC(h.normal, 0, 0, 1);
    CHECK(!meets(&s, ray(2.1, 1, 0, 0, 0, -1), &h));
    CHECK(!meets(&s, ray(-0.1, 1, 0, 0, 0, -1), &h));
    CHECK(!meets(&s, ray(1, -0.1, 0, 0, 0, -1), &h));
}

/* The mesh has one face as above; its normals lean to x, y and z: with the weights 1/4, 1/4, 1/2 they add up to (1, 1,
 * 2)/4. */
TEST(mesh)
{
    static const struct tia_vec3 vertices[] = {TIA_VEC3(0, 0, -2), TIA_VEC3(4, 0, -2), TIA_VEC3(0, 2, -2)};
    static const struct tia_dir3 normals[] = {{TIA_Q30(1), 0, 0}, {0, TIA_Q30(0.5), 0}, {0, 0, TIA_Q30(1.5)}};
    static const struct tia_uv uvs[] = {{TIA_Q16(0), TIA_Q16(8)}, {TIA_Q16(4), TIA_Q16(0)}, {TIA_Q16(2), TIA_Q16(2)}};
    struct tia_face faces[2] = {{{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}}}, {{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}}};
    struct tia_shape s = {.kind = TIA_MESH, .mesh = 0};
    struct hit h;

    meshes[0] = (struct tia_mesh){vertices, normals, uvs, faces, 3, 3, 3, 2, NULL};
    CHECK(meets(&s, ray(1, 1, 0, 0, 0, -1), &h));
    NEAR(h.t, 2);
    NEAR_VEC(h.normal, 0, 0, 1);
    NEAR_VEC(h.smooth, 1 / sqrt(6), 1 / sqrt(6), 2 / sqrt(6));
    NEAR(h.u, 2);
    NEAR(h.v, 3);
    for (int i = 0; i < 3; i++)
        faces[1].corner[i].normal = faces[1].corner[i].uv = TIA_NO_INDEX;
    CHECK(meets(&s, ray(1, 1, 0, 0, 0, -1), &h));
    NEAR_VEC(h.smooth, 0, 0, 1);
    CHECK_EQ(h.part, 1);
    NEAR(h.u, 0.25);
    NEAR(h.v, 0.5);
}

/* Cells are 2 wide from the origin: in x one of material 0, one of 0, one of 1, one empty, one of 0. */
TEST(grid)
{
    static const uint8_t cells[5] = {1, 1, 2, 0, 1};
    struct tia_shape s = {.kind = TIA_GRID, .material = 7, .grid = 0};
    struct hit h;

    grids[0] = (struct tia_grid){TIA_VEC3(0, 0, 0), TIA_Q16(2), {5, 1, 1}, cells};
    CHECK(meets(&s, ray(-1, 1.5, 0.5, 1, 0, 0), &h));
    NEAR(h.t, 1);
    NEAR_VEC(h.normal, -1, 0, 0);
    CHECK_EQ(h.material, 7);
    NEAR(h.u, 0.25); /* (z, y) of the cell */
    NEAR(h.v, 0.75);
    CHECK(meets(&s, ray(1, 1, 1, 1, 0, 0), &h)); /* through an equal cell, to the front of a different one */
    NEAR(h.t, 3);
    NEAR_VEC(h.normal, -1, 0, 0);
    CHECK_EQ(h.material, 8);
    CHECK(meets(&s, ray(5, 1, 1, 1, 0, 0), &h)); /* into the empty cell */
    CHECK_EQ(h.part, 6 * 2 + 1);
    NEAR(h.t, 1);
    NEAR_VEC(h.normal, 1, 0, 0);
    CHECK_EQ(h.material, 8);
    CHECK(meets(&s, ray(7, 1, 1, 1, 0, 0), &h)); /* and through the empty cell */
    NEAR(h.t, 1);
    NEAR_VEC(h.normal, -1, 0, 0);
    CHECK_EQ(h.material, 7);
    CHECK(!meets(&s, ray(7, 1, 1, 0, 1, 0), &h));
    CHECK(meets(&s, ray(3, 1, 1, 0, 1, 0), &h));
    NEAR(h.t, 1);
}

/* A rotation by 90 degrees about x takes y to z, about y it takes z to x, about z it takes x to y. */
TEST(rotations)
{
    struct tia_transform t = {TIA_VEC3(1, 2, 3), TIA_VEC3(90, 0, 0), TIA_VEC3(2, 3, 4)};
    struct oracle_vec y = {0, 1, 0};

    NEAR_VEC(transform_turn(&t, y), 0, 0, 1);
    NEAR_VEC(transform_point(&t, y), 1, 2, 6);
    t.rotation.y = TIA_Q16(90);
    NEAR_VEC(transform_turn(&t, y), 1, 0, 0);
    t.rotation.z = TIA_Q16(90);
    NEAR_VEC(transform_turn(&t, y), 0, 1, 0);
    t.rotation = (struct tia_vec3)TIA_VEC3(20, -35, 110);
    NEAR_VEC(transform_turn_back(&t, transform_turn(&t, y)), 0, 1, 0);
}

/* The ellipse x^2/4 + y^2 = 1 has at (sqrt 2, sqrt 1/2) the normal along (x/4, y) = (sqrt 2/4, sqrt 2/2). */
TEST(ellipsoid)
{
    struct tia_shape s = {.kind = TIA_SPHERE, .transform = 1, .sphere = {TIA_VEC3(0, 0, 0), TIA_Q16(1)}};
    struct hit h;

    transforms[0] = (struct tia_transform){TIA_VEC3(0, 0, -9), TIA_VEC3(0, 0, 0), TIA_VEC3(2, 1, 1)};
    CHECK(meets(&s, (struct ray){{sqrt(2), 5, -9}, {0, -1, 0}}, &h));
    NEAR(h.t, 5 - sqrt(0.5));
    NEAR_VEC(h.normal, 1 / sqrt(5), 2 / sqrt(5), 0);
    NEAR(h.u, 0.5); /* z = 0, x > 0 */
    NEAR(h.v, 0.75);
    transforms[0].rotation.z = TIA_Q16(90);
    CHECK(meets(&s, ray(0, 5, -9, 0, -1, 0), &h));
    NEAR(h.t, 3);
}

int main(void)
{
    RUN(plane);
    RUN(axes_of_a_normal);
    RUN(points_farther_than_65536_are_not_met);
    RUN(disc);
    RUN(sphere);
    RUN(cylinder);
    RUN(caps);
    RUN(cone);
    RUN(cone_along_its_side);
    RUN(box);
    RUN(triangle);
    RUN(mesh);
    RUN(grid);
    RUN(rotations);
    RUN(ellipsoid);
    return check_status();
}
