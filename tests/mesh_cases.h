/* mesh_cases.h - tests src/render/geometry/mesh.c in the arithmetic for which it is compiled: no ray passes between two
 * adjacent faces, and the face found is the nearest of all faces. */
#include "mesh_made.h"
#include "render/geometry/triangle.h"

static struct shape shape_of(const struct made *m)
{
    struct shape shape;

    prepare_mesh_alone(&shape, &m->mesh, m->tree.node_count ? &m->tree : NULL);
    return shape;
}

static real3 vertex(const struct made *m, uint32_t face, int k)
{
    return real3_vec(m->vertices[m->faces[face].corner[k].vertex]);
}

/* Returns a point on an edge of a random face, often an end of the edge. */
static real3 edge_point(const struct made *m, uint32_t *face)
{
    *face = (uint32_t)(random_bits() % m->mesh.face_count);
    int k = (int)(random_bits() % 3);
    real3 a = vertex(m, *face, k), b = vertex(m, *face, (k + 1) % 3);
    unsigned way = (unsigned)(random_bits() % 4);

    return way == 0 ? a : plus(a, minus(b, a), way == 1 ? 0.5L : (random_real() + 1) / 2);
}

static bool meets(const struct shape *shape, const struct ray *ray, struct intersection *intersection)
{
    bool met = shape->kind->intersect(shape, ray, NUM_LENGTH_MAX, intersection);

    CHECK_EQ(shape->kind->occluded(shape, ray, NUM_LENGTH_MAX), met);
    return met;
}

/* Checks rays from inside a convex mesh, through edges and corners. */
static void check_inside(const struct made *m, real3 centre, long double within, int rays)
{
    struct shape shape = shape_of(m);
    struct intersection intersection;

    for (int i = 0; i < rays; i++) {
        uint32_t face;
        real3 to = edge_point(m, &face);
        struct ray ray = ray_towards(plus(centre, random_real3(within), 1), to);
        bool met = meets(&shape, &ray, &intersection);
        CHECK_MSG(met, "ray %d goes through", i);
        long double away = length(minus(to, real3_of(ray.origin)));
        if (met)
            CHECK_MSG(fabsl(real_of(intersection.t) - away) < 1e-9L * (1 + away), "t %Lg, not %Lg",
                      real_of(intersection.t), away);
    }
}

/* True if all faces whose planes contain the point face the eye. */
static bool faces_eye(const struct made *m, real3 eye, real3 point)
{
    long double apart = length(minus(eye, point));

    for (uint32_t f = 0; f < m->mesh.face_count; f++) {
        real3 a = vertex(m, f, 0), n = unit(cross(minus(vertex(m, f, 1), a), minus(vertex(m, f, 2), a)));
        if (fabsl(dot(n, minus(point, a))) < 1e-7L * apart && dot(n, minus(eye, a)) < 1e-3L * apart)
            return false;
    }
    return true;
}

/* Checks rays from outside to a convex mesh, whose faces turn outwards. */
static void check_outside(const struct made *m, real3 centre, long double away, int rays)
{
    struct shape shape = shape_of(m);
    struct intersection intersection;
    int seen = 0;

    for (int i = 0; i < rays; i++) {
        uint32_t face;
        real3 to = edge_point(m, &face), from = plus(centre, random_real3(1), away);
        struct ray ray = ray_towards(from, to);
        if (!faces_eye(m, from, to))
            continue;
        bool met = meets(&shape, &ray, &intersection);
        long double distance = length(minus(to, real3_of(ray.origin)));
        seen++;
        CHECK_MSG(met && fabsl(real_of(intersection.t) - distance) < 1e-8L * (1 + distance), "ray %d: t %Lg, not %Lg",
                  i, met ? real_of(intersection.t) : -1, distance);
    }
    CHECK(seen > rays / 20);
}

TEST(spheres_of_triangles_have_no_holes)
{
    static const long double radii[] = {0x1p-6L, 1, 37.3L, 9000};

    for (size_t i = 0; i < sizeof radii / sizeof radii[0]; i++) {
        struct tia_vec3 centre = random_vec(20000);
        struct made *m = made_sphere(centre, radii[i], 2);
        check_inside(m, real3_vec(centre), radii[i] / 2, 3000);
        made_tree(m);
        check_inside(m, real3_vec(centre), radii[i] / 2, 3000);
        check_outside(m, real3_vec(centre), 3 * radii[i], 1000);
        made_free(m);
    }
}

TEST(cubes_have_no_holes)
{
    struct made *m = made_cube((struct tia_vec3){-TIA_Q16_ONE, -TIA_Q16_ONE, -TIA_Q16_ONE}, 2 * TIA_Q16_ONE);

    check_inside(m, (real3){0, 0, 0}, 0.9L, 10000);
    check_outside(m, (real3){0, 0, 0}, 30, 5000);
    made_free(m);
}

/* Rays along the axes whose coordinates are multiples of 1/2. Some of them meet edges and corners of the cube's
 * outline. */
TEST(rays_along_axes_meet_edges_and_corners)
{
    struct made *m = made_cube((struct tia_vec3){-TIA_Q16_ONE, -TIA_Q16_ONE, -TIA_Q16_ONE}, 2 * TIA_Q16_ONE);
    struct intersection intersection;

    for (int with_tree = 0; with_tree < 2; with_tree++) {
        struct shape shape = shape_of(m);
        for (int n = 0; n < 5 * 5 * 3; n++) {
            num_length a = (n % 5 - 2) * NUM_LENGTH_ONE / 2, b = (n / 5 % 5 - 2) * NUM_LENGTH_ONE / 2,
                       far = 3 * NUM_LENGTH_ONE;
            num_unit d = -NUM_UNIT_ONE;
            struct ray rays[3] = {{{far, a, b}, {d, 0, 0}}, {{a, far, b}, {0, d, 0}}, {{a, b, far}, {0, 0, d}}};
            CHECK_MSG(meets(&shape, &rays[n / 25], &intersection), "%d", n);
            CHECK(intersection.t == 2 * NUM_LENGTH_ONE);
        }
        made_tree(m);
    }
    made_free(m);
}

TEST(tetrahedra_have_no_holes)
{
    for (int i = 0; i < 300; i++) {
        long double size = powl(2, 14 - (long double)(random_bits() % 22));
        struct made *m = made_tetrahedron(size);
        real3 inside = {0, 0, 0};
        for (int k = 0; k < 4; k++)
            inside = plus(inside, real3_vec(m->vertices[k]), 0.25L);
        check_inside(m, inside, 0, 60);
        made_free(m);
    }
}

/* Compares the search in a mesh of random faces with a test of each face. */
static void check_nearest(const struct made *m, long double size, int rays, unsigned hits[2])
{
    struct shape shape = shape_of(m);

    for (int i = 0; i < rays; i++) {
        struct ray ray = ray_towards(random_real3(2 * size), random_real3(size));
        struct triangle_ray start;
        struct intersection wanted = {NUM_LENGTH_MAX, TIA_NO_INDEX}, got = {0, 0};
        triangle_ray_prepare(&start, &ray);
        for (uint32_t f = 0; f < m->mesh.face_count; f++) {
            const struct tia_corner *c = m->faces[f].corner;
            struct triangle_corners corners = {
                {m->vertices[c[0].vertex], m->vertices[c[1].vertex], m->vertices[c[2].vertex]}};
            num_length t;
            if (triangle_intersect(&start, &corners, NUM_LENGTH_MAX, &t) && t < wanted.t)
                wanted = (struct intersection){t, f};
        }
        bool met = meets(&shape, &ray, &got);
        CHECK_EQ(met, wanted.element != TIA_NO_INDEX);
        hits[met]++;
        if (!met)
            continue;
        CHECK_MSG(got.t == wanted.t && got.element == wanted.element, "face %u, not %u", got.element, wanted.element);
        CHECK(shape.kind->occluded(&shape, &ray, got.t));
        CHECK(!shape.kind->occluded(&shape, &ray, got.t - got.t / 1048576 - 4 * NUM_LENGTH_LEAST));
    }
}

TEST(the_nearest_of_all_faces_is_found)
{
    for (int i = 0; i < 40; i++) {
        long double size = powl(2, 14 - (long double)(random_bits() % 20));
        unsigned hits[2] = {0, 0};
        struct made *m = made_disorder(size, 60);
        check_nearest(m, size, 100, hits);
        made_tree(m);
        check_nearest(m, size, 300, hits);
        CHECK_MSG(hits[0] > 0 && hits[1] > 20, "%u missed, %u met", hits[0], hits[1]);
        made_free(m);
    }
}

TEST(of_equal_faces_the_lower_is_met)
{
    struct made *m = made_disorder(8, 8);
    struct intersection intersection;
    unsigned met = 0;

    for (uint32_t f = 0; f < 4; f++)
        m->faces[4 + f] = m->faces[3 - f];
    for (int i = 0; i < 2000; i++) {
        struct ray ray = ray_towards(random_real3(16), random_real3(8));
        struct shape shape = shape_of(m);
        if (meets(&shape, &ray, &intersection)) {
            met++;
            CHECK(intersection.element < 4);
        }
        if (i == 1000)
            made_tree(m);
    }
    CHECK(met > 200);
    made_free(m);
}

static real3 blend(const real3 v[3], const long double part[3])
{
    return plus(plus(plus((real3){0, 0, 0}, v[0], part[0]), v[1], part[1]), v[2], part[2]);
}

TEST(normals_and_uv_are_interpolated)
{
    struct made *m = made_disorder(100, 50);
    struct shape shape = shape_of(m);

    made_dress(m);
    for (int i = 0; i < 5000; i++) {
        uint32_t f = (uint32_t)(random_bits() % m->mesh.face_count);
        long double u = (random_real() + 1) / 2, v = (random_real() + 1) / 2 * (1 - u), part[3] = {1 - u - v, u, v};
        const struct tia_corner *c = m->faces[f].corner;
        real3 at[3], normal[3], uv[3];
        for (int k = 0; k < 3; k++) {
            struct tia_dir3 n = m->normals[c[k].normal];
            at[k] = vertex(m, f, k);
            normal[k] = unit((real3){n.x, n.y, n.z});
            uv[k] = (real3){m->uvs[c[k].uv].u / 65536.0L, m->uvs[c[k].uv].v / 65536.0L, 0};
        }
        real3 n = cross(minus(at[1], at[0]), minus(at[2], at[0])), wanted = blend(uv, part);
        struct num_point point = point_of(blend(at, part));
        struct surface surface;
        num_length got[2];
        if (length(n) < 1000 || length(blend(normal, part)) < 0.01L)
            continue;
        shape.kind->surface(&shape, point, f, &surface);
        CHECK(length(minus(real3_dir(surface.normal), unit(n))) < 1e-12L);
        CHECK(length(minus(real3_dir(surface.smooth), unit(blend(normal, part)))) < 1e-9L);
        shape.kind->uv(&shape, point, f, got);
        CHECK(fabsl(real_of(got[0]) - wanted.x) < 1e-9L && fabsl(real_of(got[1]) - wanted.y) < 1e-9L);
    }
    made_free(m);
}

TEST(a_bare_mesh_has_flat_normals_and_barycentric_uv)
{
    struct made *m = made_cube((struct tia_vec3){0, 0, 0}, TIA_Q16_ONE);
    struct shape shape = shape_of(m);
    real3 at[3] = {vertex(m, 3, 0), vertex(m, 3, 1), vertex(m, 3, 2)};
    struct num_point point = point_of(blend(at, (const long double[3]){0.5L, 0.25L, 0.25L}));
    struct surface surface;
    num_length uv[2];

    shape.kind->surface(&shape, point, 3, &surface);
    CHECK(!memcmp(&surface.normal, &surface.smooth, sizeof surface.normal));
    shape.kind->uv(&shape, point, 3, uv);
    CHECK(fabsl(real_of(uv[0]) - 0.25L) < 1e-12L && fabsl(real_of(uv[1]) - 0.25L) < 1e-12L);
    made_free(m);
}

/* The normals of corners 0 and 1 cancel in the middle between them. */
TEST(where_normals_cancel_the_face_has_its_own)
{
    struct made *m = made_disorder(8, 1);
    struct shape shape = shape_of(m);
    struct surface surface;

    made_dress(m);
    for (uint32_t k = 0; k < 3; k++) {
        m->vertices[k] = (struct tia_vec3){k == 1 ? TIA_Q16(4) : 0, k == 2 ? TIA_Q16(4) : 0, 0};
        m->normals[k] = (struct tia_dir3){k == 1 ? -TIA_Q30_ONE : TIA_Q30_ONE, 0, 0};
        m->faces[0].corner[k] = (struct tia_corner){k, k, k};
    }
    shape.kind->surface(&shape, (struct num_point){2 * NUM_LENGTH_ONE, 0, 0}, 0, &surface);
    CHECK(!memcmp(&surface.normal, &surface.smooth, sizeof surface.normal));
    made_free(m);
}

TEST(an_empty_mesh_is_never_met)
{
    static const struct tia_mesh empty;
    static const struct tia_bvh_tree no_tree;
    struct ray ray = ray_towards((real3){0, 0, 0}, (real3){1, 1, 1});
    struct shape shape;
    struct intersection intersection;

    prepare_mesh_alone(&shape, &empty, NULL);
    CHECK(!meets(&shape, &ray, &intersection));
    prepare_mesh_alone(&shape, &empty, &no_tree);
    CHECK(!meets(&shape, &ray, &intersection));
}

int main(void)
{
    RUN(spheres_of_triangles_have_no_holes);
    RUN(cubes_have_no_holes);
    RUN(rays_along_axes_meet_edges_and_corners);
    RUN(tetrahedra_have_no_holes);
    RUN(the_nearest_of_all_faces_is_found);
    RUN(of_equal_faces_the_lower_is_met);
    RUN(normals_and_uv_are_interpolated);
    RUN(a_bare_mesh_has_flat_normals_and_barycentric_uv);
    RUN(where_normals_cancel_the_face_has_its_own);
    RUN(an_empty_mesh_is_never_met);
    return check_status();
}
