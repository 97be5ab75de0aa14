/* Flat faces of curved shapes, measured in double precision against the true surface. */
#include <math.h>
#include <stdlib.h>

#include <tia/render.h>

#include "check.h"
#include "flat/source.h"
#include "random.h"

#define Q TIA_Q16
#define PI 3.14159265358979323846

enum { POINTS_MAX = 1 << 17 };

static struct cancel never;
static double own[POINTS_MAX][3];
static struct tia_flat_face faces[2 * POINTS_MAX];
static uint32_t across[2 * POINTS_MAX * TIA_SIDES];

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* ---- a shape by its equations ---- */

struct truth {
    enum tia_shape_kind kind;
    double base[3], axis[3], length, radius[2]; /* of a sphere: base and radius[0]; a disc has length 0 */
    double scale[3];
    bool capped;
};

static void set(double to[3], struct tia_vec3 from)
{
    to[0] = from.x / 65536.0;
    to[1] = from.y / 65536.0;
    to[2] = from.z / 65536.0;
}

static void set_axis(struct truth *t, double x, double y, double z)
{
    t->length = sqrt(x * x + y * y + z * z);
    t->axis[0] = x / t->length;
    t->axis[1] = y / t->length;
    t->axis[2] = z / t->length;
}

static struct truth truth_of(const struct tia_shape *s, struct tia_vec3 scale)
{
    struct truth t = {.kind = s->kind};
    double top[3];

    set(t.scale, scale);
    if (s->kind == TIA_SPHERE) {
        set(t.base, s->sphere.centre);
        t.radius[0] = s->sphere.radius / 65536.0;
    } else if (s->kind == TIA_DISC) {
        set(t.base, s->disc.centre);
        set_axis(&t, s->disc.normal.x, s->disc.normal.y, s->disc.normal.z);
        t.length = 0;
        t.radius[0] = t.radius[1] = s->disc.radius / 65536.0;
    } else {
        bool cone = s->kind == TIA_CONE;
        set(t.base, cone ? s->cone.base : s->cylinder.base);
        set(top, cone ? s->cone.top : s->cylinder.top);
        set_axis(&t, top[0] - t.base[0], top[1] - t.base[1], top[2] - t.base[2]);
        t.radius[0] = (cone ? s->cone.base_radius : s->cylinder.radius) / 65536.0;
        t.radius[1] = (cone ? s->cone.top_radius : s->cylinder.radius) / 65536.0;
        t.capped = cone ? s->cone.capped : s->cylinder.capped;
    }
    return t;
}

/* Returns the distance, in the world, of point p of part `element` of the shape from the surface in the same direction
 * from the centre or the axis; -1 if the point is outside. */
static double distance(const struct truth *t, const double p[3], uint32_t element)
{
    double from[3] = {p[0] - t->base[0], p[1] - t->base[1], p[2] - t->base[2]}, way[3], sum = 0;
    double height = t->kind == TIA_SPHERE ? 0 : dot(from, t->axis), radius = t->radius[0];

    if (t->kind != TIA_SPHERE && t->length > 0)
        radius += (t->radius[1] - radius) * height / t->length;
    for (int k = 0; k < 3; k++)
        way[k] = from[k] - (t->kind == TIA_SPHERE ? 0 : height * t->axis[k]);
    double rho = sqrt(dot(way, way)), off = radius - rho;
    bool flat = t->kind == TIA_DISC || element > 0;
    double level = element == 2 ? t->length : 0;
    for (int k = 0; k < 3; k++) {
        double d = (flat ? (level - height) * t->axis[k] : rho > 0 ? way[k] / rho * off : off) * t->scale[k];
        sum += d * d;
    }
    return off < -1e-8 ? -1 : sqrt(sum);
}

/* ---- measuring ---- */

struct measured {
    double most;   /* largest error */
    double volume; /* volume enclosed by the faces, if they are turned outwards */
};

static double cross_part(const double a[3], const double b[3], int k)
{
    return a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

/* Measures the middle of each edge and a few random points. */
static void measure_face(const struct truth *t, const struct tia_flat_face *face, uint32_t element, struct measured *m)
{
    const double *a = own[face->corner[0]], *b = own[face->corner[1]], *c = own[face->corner[2]];

    for (int i = 0; i < 6; i++) {
        double u = i < 2 ? 0.5 : random_double() / 2 + 0.5, v = i == 0 ? 0 : i == 1 ? 0.5 : random_double() / 2 + 0.5;
        double p[3];
        if (u + v > 1) {
            u = 1 - u;
            v = 1 - v;
        }
        for (int k = 0; k < 3; k++)
            p[k] = a[k] + u * (b[k] - a[k]) + v * (c[k] - a[k]);
        double d = distance(t, p, element);
        CHECK_MSG(d >= 0, "a face is outside");
        m->most = d > m->most ? d : m->most;
    }
    for (int k = 0; k < 3; k++)
        m->volume += (a[k] - t->base[k]) * (cross_part(b, c, k) + cross_part(c, a, k) + cross_part(a, b, k)) / 6;
}

static double volume_of(const struct truth *t)
{
    double r = t->radius[0], s = t->radius[1];

    return t->kind == TIA_SPHERE ? 4 * PI / 3 * r * r * r : PI / 3 * t->length * (r * r + r * s + s * s);
}

static uint32_t element_of(const struct tia_flat_source *source, uint32_t face)
{
    return face < source->parts[0] ? 0 : face - source->parts[0] < source->parts[1] ? 1 : 2;
}

static void check_shape(const struct tia_scene *scene, const struct truth *t, double error)
{
    struct tia_flat_source source;
    struct measured m = {0, 0};
    struct tia_facets facets;

    CHECK(tia_facets_of(scene, 0, &facets) && facets.points <= POINTS_MAX && facets.faces <= 2 * POINTS_MAX);
    CHECK(facets.around % 4 == 0);
    tia_flat_source_init(&source, scene, 0);
    CHECK_EQ(source.points, facets.points);
    for (uint32_t i = 0; i < source.points; i++) {
        int64_t p[3];
        tia_facet_point(&source.facets, i, p);
        for (int k = 0; k < 3; k++)
            own[i][k] = (double)p[k] / 4294967296.0;
    }
    for (uint32_t i = 0; i < source.faces; i++) {
        faces[i] = tia_flat_source_face(&source, i);
        for (int k = 0; k < 3; k++)
            CHECK(faces[i].corner[k] < source.points);
        measure_face(t, &faces[i], element_of(&source, i), &m);
    }
    CHECK_MSG(m.most <= error, "%g away, not %g", m.most, error);
    CHECK_MSG(facets.around < 24 || t->kind == TIA_DISC || m.most > 0.4 * error * t->scale[0] / 1.6,
              "%g away with %u corners, %g would do", m.most, facets.around, error);
    void *room = malloc(tia_edges_room(source.faces));
    bool closed = tia_edges_join(across, faces, source.faces, room, &never);
    free(room);
    CHECK_EQ(closed, t->capped || t->kind == TIA_SPHERE);
    if (closed)
        CHECK_MSG(m.volume < volume_of(t) && m.volume > (1 - 20.0 / facets.around / facets.around) * volume_of(t),
                  "volume %g of %g", m.volume, volume_of(t));
}

/* ---- kinds ---- */

static tia_q16 between(double low, double high)
{
    return (tia_q16)((low + (high - low) * (random_double() + 1) / 2) * 65536);
}

static struct tia_shape random_shape(enum tia_shape_kind kind, int i)
{
    struct tia_shape s = {.kind = kind};
    struct tia_vec3 a = {between(-9, 9), between(-9, 9), between(-9, 9)}, b = a;

    b.x += between(-2, 2);
    b.y += between(0.5, 2);
    if (kind == TIA_SPHERE) {
        s.sphere.centre = a;
        s.sphere.radius = between(0.1, 3);
    } else if (kind == TIA_DISC) {
        s.disc.centre = a;
        s.disc.normal = (struct tia_dir3){between(-9, 9) * 1024, TIA_Q30(0.7), between(-9, 9) * 1024};
        s.disc.radius = between(0.1, 3);
    } else if (kind == TIA_CYLINDER) {
        s.cylinder = (struct tia_cylinder){a, b, between(0.1, 3), i % 2};
    } else {
        s.cone = (struct tia_cone){a, b, i % 3 == 0 ? 0 : between(0.1, 3), i % 3 == 1 ? 0 : between(0.1, 3), i % 2};
    }
    return s;
}

/* Checks shapes of a kind with several errors, which are in units of the world: scaled shapes have more faces. */
static void check_kind(enum tia_shape_kind kind)
{
    for (int i = 0; i < 24; i++) {
        struct tia_shape shape = random_shape(kind, i);
        struct tia_transform transform = {.scale = {Q(1), Q(1), Q(1)}};
        struct tia_scene scene = {.shapes = &shape, .shape_count = 1, .transforms = &transform, .transform_count = 1};
        struct truth t;

        scene.tessellated = i % 4 == 0 ? Q(0.1) : i % 4 == 1 ? Q(0.01) : i % 4 == 2 ? Q(0.003) : 500;
        if (i % 5 == 4) {
            shape.transform = 1;
            transform.scale = (struct tia_vec3){between(0.5, 3), between(0.5, 3), between(0.5, 3)};
        }
        t = truth_of(&shape, transform.scale);
        check_shape(&scene, &t, scene.tessellated / 65536.0);
    }
}

TEST(spheres)
{
    check_kind(TIA_SPHERE);
}

TEST(discs)
{
    check_kind(TIA_DISC);
}

TEST(cylinders)
{
    check_kind(TIA_CYLINDER);
}

TEST(cones)
{
    check_kind(TIA_CONE);
}

/* Spheres of the scene itself are divided like shapes, with their fine digits. */
TEST(own_spheres)
{
    static const struct tia_sphere sphere = {{Q(1), Q(2), Q(3)}, Q(2), 0};
    static const struct tia_fine_sphere digits = {{25600, -25700, 12801}, 20481};
    static const struct tia_fine fine = {.spheres = &digits};
    struct tia_scene scene = {.spheres = &sphere, .sphere_count = 1, .tessellated = Q(0.01), .fine = &fine};
    struct truth t = {.kind = TIA_SPHERE, .scale = {1, 1, 1}};

    t.base[0] = 1 + ldexp(25600, -32);
    t.base[1] = 2 - ldexp(25700, -32);
    t.base[2] = 3 + ldexp(12801, -32);
    t.radius[0] = 2 + ldexp(20481, -32);
    check_shape(&scene, &t, 0.01);
    scene.tessellated = 0;
    CHECK(!tia_facets_of(&scene, 0, &(struct tia_facets){0}) && !tia_flat_takes(&scene, 0));
}

/* The number n of corners around satisfies n^2 >= 5 r/e, for spheres 10 r/e. Too many faces are reported without being
 * counted. */
TEST(numbers)
{
    static const struct tia_material material = {.colour = {0, 0, 0}};
    struct tia_sphere spheres[2] = {{{0, 0, 0}, Q(1), 0}, {{Q(9), 0, 0}, Q(1), 0}};
    struct tia_scene scene = {.spheres = spheres, .sphere_count = 2, .materials = &material, .material_count = 1};
    struct tia_fault fault = {"", 0, "", ""};
    struct tia_facets f;

    scene.camera = (struct tia_camera){.eye = {0, 0, Q(20)}, .fov = Q(50)};
    scene.shadows = TIA_SHADOWS_ZFAIL;
    scene.tessellated = Q(0.1);
    CHECK(tia_facets_of(&scene, 1, &f) && f.around == 12 && f.points == 12 * 5 + 2 && f.faces == 2 * 12 * 5);
    CHECK_EQ(tia_scene_check(&scene, &fault), TIA_OK);
    scene.tessellated = 1; /* n = 812, 658532 faces each */
    CHECK(tia_facets_of(&scene, 0, &f) && f.around == 812 && f.faces == 2 * 812 * 405);
    CHECK_EQ(tia_scene_check(&scene, &fault), TIA_OK);
    spheres[1].radius = Q(60); /* n = 6272, 39 million */
    CHECK_EQ(tia_scene_check(&scene, &fault), TIA_ERR_RANGE);
    CHECK(!strcmp(fault.thing, "scene") && !strcmp(fault.field, "tessellated"));
    spheres[1].radius = Q(30000);
    CHECK(tia_facets_of(&scene, 1, &f) && f.faces > TIA_OBJECTS_MAX);
    CHECK_EQ(tia_view_size(&scene, 0), SIZE_MAX);
    scene.tessellated = -1;
    CHECK_EQ(tia_scene_check(&scene, &fault), TIA_ERR_RANGE);
}

int main(void)
{
    RUN(spheres);
    RUN(discs);
    RUN(cylinders);
    RUN(cones);
    RUN(own_spheres);
    RUN(numbers);
    return check_status();
}
