/* The .nff reader against the Standard Procedural Databases, read a second time with strtod. */
#include <math.h>

#include "reading.h"

#define SCENES "scenes/nff/"

static const char *const names[] = {"balls_2", "balls_3", "balls_4",  "gears_1",  "jacks_3", "lattice_3",
                                    "mount_3", "rings_3", "shells_2", "teapot_3", "tetra_4", "tree_4"};
#define NAMES (sizeof names / sizeof *names)

/* Returns a decimal as Q16.16, halves away from zero. */
static tia_q16 q16(double x)
{
    return (tia_q16)lround(x * 65536);
}

/* Returns a length with its fine digits: 32 + scale_bits bits are behind the point. */
static int64_t fine(const struct tia_scene *scene, double x)
{
    return llround(ldexp(x, 32 + (int)scene->scale_bits));
}

static tia_q30 q30(double x)
{
    return (tia_q30)lround(x * 1073741824);
}

static bool load(struct reading *r, const char *name, char **text)
{
    char path[100];
    size_t length = 0;

    (void)snprintf(path, sizeof path, SCENES "%s.nff", name);
    *text = load_file(path, &length);
    CHECK_MSG(*text, "no %s", path);
    if (!*text)
        return false;
    *r = (struct reading){.reader = {.format = TIA_FORMAT_NFF, .text = *text, .length = length}};
    read_begin(r);
    CHECK_MSG(!r->status, "%s:%u:%u: %s", path, (unsigned)r->reader.error.line, (unsigned)r->reader.error.column,
              r->reader.error.text);
    return !r->status;
}

/* ---- the second reader: these files' statements, in their order ---- */

struct second {
    const char *at; /* the unread text */
    const struct tia_scene *scene;
    uint32_t sphere, shape, mesh, face, vertex, normal, material, light;
    bool in_mesh;
};

static double number(struct second *s)
{
    char *end;
    double x = strtod(s->at, &end);

    CHECK(end != s->at);
    s->at = end;
    return x;
}

static void check_vec3(struct second *s, const struct tia_vec3 *got)
{
    CHECK_EQ(got->x, q16(ldexp(number(s), (int)s->scene->scale_bits)));
    CHECK_EQ(got->y, q16(ldexp(number(s), (int)s->scene->scale_bits)));
    CHECK_EQ(got->z, q16(ldexp(number(s), (int)s->scene->scale_bits)));
}

static void check_length(struct second *s, tia_q16 got, int16_t digits)
{
    int64_t off = got * INT64_C(65536) + digits - fine(s->scene, number(s));

    CHECK(off >= -1 && off <= 1); /* the double itself is rounded, and may be on the other side of a half */
}

static void check_fine(struct second *s, const struct tia_vec3 *got, const struct tia_fine_place *digits)
{
    check_length(s, got->x, digits->x);
    check_length(s, got->y, digits->y);
    check_length(s, got->z, digits->z);
}

static void check_normal(struct second *s, const struct tia_dir3 *got)
{
    double x = number(s), y = number(s), z = number(s), length = sqrt(x * x + y * y + z * z);

    CHECK(fabs(got->x - x / length * 1073741824) < 4 && fabs(got->y - y / length * 1073741824) < 4 &&
          fabs(got->z - z / length * 1073741824) < 4);
}

static double edge(const struct tia_vec3 *a, const struct tia_vec3 *b, int axis)
{
    return (axis == 0 ? b->x - a->x : axis == 1 ? b->y - a->y : b->z - a->z) / 65536.0;
}

/* Adds (b - a) x (c - a). */
static void add_cross(double sum[3], const struct tia_vec3 *a, const struct tia_vec3 *b, const struct tia_vec3 *c)
{
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        sum[i] += edge(a, b, j) * edge(a, c, k) - edge(a, b, k) * edge(a, c, j);
    }
}

/* Checks the faces of a polygon: they have its vertices, and together its area and side. */
static void check_faces(struct second *s, const struct tia_mesh *mesh, uint32_t count, bool has_normals)
{
    double whole[3] = {0}, sum[3] = {0};
    const struct tia_vec3 *v = mesh->vertices;

    for (uint32_t i = 1; i + 1 < count; i++)
        add_cross(whole, &v[s->vertex], &v[s->vertex + i], &v[s->vertex + i + 1]);
    for (uint32_t i = 0; i < count - 2; i++) {
        const struct tia_corner *c = mesh->faces[s->face++].corner;
        for (int k = 0; k < 3; k++) {
            CHECK(c[k].vertex >= s->vertex && c[k].vertex < s->vertex + count && c[k].uv == TIA_NO_INDEX);
            CHECK_EQ(c[k].normal, has_normals ? s->normal + (c[k].vertex - s->vertex) : TIA_NO_INDEX);
        }
        add_cross(sum, &v[c[0].vertex], &v[c[1].vertex], &v[c[2].vertex]);
    }
    for (int i = 0; i < 3; i++)
        CHECK_MSG(fabs(sum[i] - whole[i]) < ldexp(1e-9, 2 * (int)s->scene->scale_bits), "area %g, not %g", sum[i],
                  whole[i]);
}

static void check_polygon(struct second *s, bool has_normals)
{
    uint32_t count = (uint32_t)number(s);
    const struct tia_shape *shape = &s->scene->shapes[s->in_mesh ? s->shape - 1 : s->shape++];
    const struct tia_mesh *mesh = &s->scene->meshes[s->mesh];

    s->in_mesh = true;
    CHECK(shape->kind == TIA_MESH && shape->mesh == s->mesh && shape->material == s->material - 1);
    CHECK(s->mesh < s->scene->mesh_count && s->vertex + count <= mesh->vertex_count);
    for (uint32_t i = 0; i < count; i++) {
        check_vec3(s, &mesh->vertices[s->vertex + i]);
        if (has_normals)
            check_normal(s, &mesh->normals[s->normal + i]);
    }
    check_faces(s, mesh, count, has_normals);
    s->vertex += count;
    s->normal += has_normals ? count : 0;
}

static void check_cone(struct second *s)
{
    const struct tia_fine_ends *digits = &s->scene->fine->shapes[s->shape];
    const struct tia_shape *shape = &s->scene->shapes[s->shape++];
    bool is_cone = shape->kind == TIA_CONE;

    CHECK(shape->material == s->material - 1 && (is_cone || shape->kind == TIA_CYLINDER));
    check_fine(s, is_cone ? &shape->cone.base : &shape->cylinder.base, &digits->base);
    check_length(s, is_cone ? shape->cone.base_radius : shape->cylinder.radius, digits->base_radius);
    check_fine(s, is_cone ? &shape->cone.top : &shape->cylinder.top, &digits->top);
    check_length(s, is_cone ? shape->cone.top_radius : shape->cylinder.radius, digits->top_radius);
    CHECK(is_cone ? !shape->cone.capped && shape->cone.base_radius != shape->cone.top_radius : !shape->cylinder.capped);
}

static void tia_check_material(struct second *s)
{
    const struct tia_material *m = &s->scene->materials[s->material++];
    double r = number(s), g = number(s), b = number(s), kd = number(s), ks = number(s), shine = number(s),
           t = number(s), index = number(s);

    CHECK(abs(m->colour.r - q30(r * kd)) <= 1 && abs(m->colour.g - q30(g * kd)) <= 1 &&
          abs(m->colour.b - q30(b * kd)) <= 1);
    CHECK(m->specular.r == q30(ks) && m->specular.g == q30(ks) && m->specular.b == q30(ks));
    CHECK(m->mirror.r == q30(ks) && m->mirror.g == q30(ks) && m->mirror.b == q30(ks));
    CHECK(m->refraction.r == q30(t) && m->refraction.g == q30(t) && m->refraction.b == q30(t));
    CHECK(m->transmission.r == q30(t) && m->transmission.g == q30(t) && m->transmission.b == q30(t));
    CHECK_EQ(m->exponent, shine > 10000 ? TIA_EXPONENT_MAX : q16(shine));
    CHECK_EQ(m->index, t > 0 ? q16(index) : TIA_Q16_ONE);
    if (s->in_mesh)
        s->mesh++;
    s->in_mesh = false;
    s->vertex = s->normal = s->face = 0;
}

static void tia_check_light(struct second *s)
{
    const struct tia_light *l = &s->scene->lights[s->light++];
    double intensity = 1 / sqrt(s->scene->light_count);

    check_vec3(s, &l->centre);
    CHECK(l->kind == TIA_POINT_LIGHT && !l->radius && !l->constant && !l->linear && !l->quadratic);
    CHECK(l->emission.r == q30(intensity) && l->emission.g == q30(intensity) && l->emission.b == q30(intensity));
}

/* Checks an up vector of any length. */
static void check_up(struct second *s, struct tia_vec3 got)
{
    double x = number(s), y = number(s), z = number(s), length = sqrt(x * x + y * y + z * z);
    double other = sqrt((double)got.x * got.x + (double)got.y * got.y + (double)got.z * got.z);

    CHECK(fabs(got.x / other - x / length) < 1e-8 && fabs(got.y / other - y / length) < 1e-8 &&
          fabs(got.z / other - z / length) < 1e-8);
}

static void check_view(struct second *s, const char *word)
{
    const struct tia_scene *scene = s->scene;

    if (!strcmp(word, "b")) {
        CHECK_EQ(scene->background.r, q30(number(s)));
        CHECK_EQ(scene->background.g, q30(number(s)));
        CHECK_EQ(scene->background.b, q30(number(s)));
    } else if (!strcmp(word, "from")) {
        check_fine(s, &scene->camera.eye, &scene->fine->eye);
    } else if (!strcmp(word, "at")) {
        check_fine(s, &scene->camera.reference, &scene->fine->reference);
    } else if (!strcmp(word, "up")) {
        check_up(s, scene->camera.up);
    } else if (!strcmp(word, "angle")) {
        CHECK_EQ(scene->camera.fov, q16(number(s)));
    } else {
        CHECK_MSG(!strcmp(word, "v") || !strcmp(word, "hither") || !strcmp(word, "resolution"), "'%s'", word);
        s->at += strcspn(s->at, "\n");
    }
}

static void check_statement(struct second *s, const char *word)
{
    if (!strcmp(word, "s")) {
        const struct tia_fine_sphere *digits = &s->scene->fine->spheres[s->sphere];
        const struct tia_sphere *sphere = &s->scene->spheres[s->sphere++];
        check_fine(s, &sphere->centre, &digits->centre);
        check_length(s, sphere->radius, digits->radius);
        CHECK_EQ(sphere->material, s->material - 1);
    } else if (!strcmp(word, "c")) {
        check_cone(s);
    } else if (!strcmp(word, "p") || !strcmp(word, "pp")) {
        check_polygon(s, word[1] == 'p');
    } else if (!strcmp(word, "f")) {
        tia_check_material(s);
    } else if (!strcmp(word, "l")) {
        tia_check_light(s);
    } else {
        check_view(s, word);
    }
}

TEST(databases)
{
    for (size_t i = 0; i < NAMES; i++) {
        struct reading r;
        char *text, word[20];
        int length;

        if (!load(&r, names[i], &text))
            continue;
        struct second s = {.at = text, .scene = &r.scene};
        while (sscanf(s.at, "%19s%n", word, &length) == 1) {
            s.at += length;
            check_statement(&s, word);
        }
        CHECK_EQ(r.scene.sphere_count, s.sphere);
        CHECK_EQ(r.scene.shape_count, s.shape);
        CHECK_EQ(r.scene.mesh_count, s.mesh + s.in_mesh);
        CHECK_EQ(r.scene.material_count, s.material);
        CHECK_EQ(r.scene.light_count, s.light);
        CHECK(s.sphere + s.shape > 0 && r.scene.camera.projection == TIA_PERSPECTIVE && !r.scene.depth);
        read_end(&r);
        free(text);
    }
}

#define VIEW "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 40\n"

TEST(what_is_not_said)
{
    struct reading r;

    read_string(&r, TIA_FORMAT_NFF, VIEW "l 1 2 3\nl 0 9 0 1 0.5 0.25\ns 0 0 0 1\n");
    CHECK_EQ(r.status, TIA_OK);
    CHECK(!r.scene.background.r && !r.scene.background.g && !r.scene.background.b);
    CHECK_EQ(r.scene.material_count, 1);
    CHECK(r.scene.materials[0].colour.r == TIA_Q30_ONE && !r.scene.materials[0].mirror.r);
    CHECK_EQ(r.scene.lights[0].emission.g, TIA_Q30(0.70710678118654752));
    CHECK(r.scene.lights[1].emission.r == TIA_Q30_ONE && r.scene.lights[1].emission.g == TIA_Q30(0.5) &&
          r.scene.lights[1].emission.b == TIA_Q30(0.25));
    read_end(&r);
}

TEST(what_is_taken_in)
{
    struct reading r;

    read_string(
        &r, TIA_FORMAT_NFF,
        "# a comment\r\n" VIEW "f 1 1 1 1 0.5 0 0.5 0 # no highlight\ns 0 0 0 -1\n"
        "f 1 1 1 1 0.5 0.25 0 7\nc 0 0 0 -1 0 1 0 -1\nf 1 1 1 1 0.5 1.5e4 0 7\n"
        "p 3 0 0 0 1 0 0 0 1 0\ns 1 1 1 1\npp 4\n0 0 1 0 0 9\n\n# between\n1 0 1 0 0 9\n1 1 1 9 0 0\n0 1 1 0 0 -9\n");
    CHECK_EQ(r.status, TIA_OK);
    const struct tia_material *m = r.scene.materials;
    CHECK(m[0].specular.r == 0 && m[0].mirror.r == TIA_Q30(0.5) && m[0].exponent == TIA_Q16_ONE);
    CHECK(m[0].index == TIA_Q16_ONE && m[0].refraction.b == TIA_Q30(0.5));
    CHECK(m[1].specular.r == TIA_Q30(0.5) && m[1].exponent == TIA_Q16_ONE && m[2].exponent == TIA_EXPONENT_MAX);
    CHECK_EQ(m[1].index, TIA_Q16_ONE);
    CHECK_EQ(r.scene.spheres[0].radius, TIA_Q16_ONE << r.scene.scale_bits);
    CHECK(r.scene.shapes[0].kind == TIA_CYLINDER && r.scene.shapes[0].cylinder.radius == TIA_Q16_ONE
                                                                                             << r.scene.scale_bits);
    CHECK(r.scene.shape_count == 2 && r.scene.mesh_count == 1 && r.scene.sphere_count == 2);
    const struct tia_mesh *mesh = r.scene.meshes;
    CHECK(mesh->vertex_count == 7 && mesh->normal_count == 4 && mesh->face_count == 3 && !mesh->uv_count);
    CHECK(mesh->faces[0].corner[0].normal == TIA_NO_INDEX && mesh->faces[1].corner[0].normal != TIA_NO_INDEX);
    CHECK(mesh->normals[0].z == TIA_Q30_ONE && mesh->normals[2].x == TIA_Q30_ONE && mesh->normals[3].z == -TIA_Q30_ONE);
    read_end(&r);
}

/* With T > 0 each polygon is a group of its own, with all its triangles; otherwise no groups are needed. */
TEST(polygons_filter_one_by_one)
{
    struct reading r;

    read_string(&r, TIA_FORMAT_NFF,
                VIEW "f 1 1 1 1 0 0 0 0\np 3\n0 0 0\n1 0 0\n0 1 0\n"
                     "f 1 1 1 0.5 0 0 0.5 1\np 3\n0 0 1\n1 0 1\n0 1 1\np 4\n0 0 2\n1 0 2\n1 1 2\n0 1 2\n"
                     "pp 4\n0 0 3 0 0 1\n1 0 3 0 0 1\n1 1 3 0 0 1\n0 1 3 0 0 1\n");
    CHECK_EQ(r.status, TIA_OK);
    CHECK_EQ(r.scene.mesh_count, 2);
    const struct tia_mesh *m = r.scene.meshes;
    if (!check_failed && m[1].groups) {
        CHECK_EQ(m[1].face_count, 5);
        CHECK(m[1].groups[1] == m[1].groups[2] && m[1].groups[3] == m[1].groups[4]);
        CHECK(m[1].groups[0] != m[1].groups[1] && m[1].groups[0] != m[1].groups[3] && m[1].groups[1] != m[1].groups[3]);
    }
    CHECK(!check_failed && !m[0].groups && m[1].groups);
    read_end(&r);
}

TEST(truncated)
{
    struct reading r;
    char *text;

    if (!load(&r, "balls_2", &text))
        return;
    read_end(&r);
    r.reader.length = 900;
    check_truncated(&r.reader);
    free(text);
    r.reader.text = VIEW "pp 4\n0 0 1 0 0 9\n1 0 1 0 0 9\n1 1 1 9 0 0\n0 1 1 0 0 -9\nc 0 0 0 1 2 2 2 1e-1\n";
    r.reader.length = strlen(r.reader.text);
    check_truncated(&r.reader);
}

int main(void)
{
    RUN(databases);
    RUN(what_is_not_said);
    RUN(what_is_taken_in);
    RUN(polygons_filter_one_by_one);
    RUN(truncated);
    return check_status();
}
