/* Models in .stl, .ply, .off and .pgm: their vertices, faces, normals and colours as computed by hand, and the same
 * scene from all encodings of a model. */
#include <math.h>

#include "model_bytes.h"
#include "random.h"
#include "read/model/binary.h"

#define ONE TIA_Q16_ONE

/* ---- binary numbers ---- */

TEST(floats)
{
    static const struct {
        uint32_t ieee;
        unsigned bits;
        int64_t want;
        enum tia_decimal result;
    } cases[] = {
        {0x3f800000, 16, 65536, TIA_DECIMAL_FINE},                     /* 1 */
        {0xbf800000, 0, -1, TIA_DECIMAL_FINE},                         /* -1 */
        {0x37000000, 16, 1, TIA_DECIMAL_FINE},                         /* 2^-17: half of a unit, away from 0 */
        {0xb7000000, 16, -1, TIA_DECIMAL_FINE},                        /* -2^-17 */
        {0x36ffffff, 16, 0, TIA_DECIMAL_FINE},                         /* just below */
        {0x00000001, 32, 0, TIA_DECIMAL_FINE},                         /* 2^-149 */
        {0x80000000, 32, 0, TIA_DECIMAL_FINE},                         /* -0 */
        {0x4effffff, 32, INT64_C(2147483520) << 32, TIA_DECIMAL_FINE}, /* the largest */
        {0x4f000000, 16, 0, TIA_DECIMAL_RANGE},                        /* 2^31 */
        {0xff800000, 16, 0, TIA_DECIMAL_RANGE},                        /* -infinity */
        {0x7fc00000, 16, 0, TIA_DECIMAL_NONE},                         /* NaN */
        {0x3dcccccd, 32, INT64_C(429496736), TIA_DECIMAL_FINE},        /* 13421773/2^27, the float next to 0.1 */
    };

    for (unsigned i = 0; i < sizeof cases / sizeof *cases; i++) {
        int64_t out = 0;
        CHECK_EQ(tia_binary_float(&out, cases[i].ieee, cases[i].bits), cases[i].result);
        CHECK_EQ(out, cases[i].want);
    }
}

/* Any double, against round() of the exact product: a double times 2^bits below 2^53 is rounded exactly. */
TEST(doubles)
{
    for (int i = 0; i < 100000; i++) {
        uint64_t bits = random_bits();
        unsigned fraction = random_u32() % 17;
        int64_t out = 0;
        double x;

        bits = (bits & ~(UINT64_C(0x7ff) << 52)) | (uint64_t)(1023 - 40 + random_u32() % 60) << 52;
        memcpy(&x, &bits, sizeof x);
        CHECK_EQ(tia_binary_double(&out, bits, fraction), TIA_DECIMAL_FINE);
        CHECK_EQ(out, (int64_t)round(ldexp(x, (int)fraction)));
    }
    int64_t out = 0;
    CHECK_EQ(tia_binary_double(&out, UINT64_C(0x7ff0000000000001), 32), TIA_DECIMAL_NONE);
    CHECK_EQ(tia_binary_double(&out, UINT64_C(0x41e0000000000000), 32), TIA_DECIMAL_RANGE);
    CHECK_EQ(tia_binary_double(&out, UINT64_C(0x3fb999999999999a), 32), TIA_DECIMAL_FINE);
    CHECK_EQ(out, 429496730); /* 0.1 2^32 = 429496729.6 */
}

static const char text_stl[] = "solid four\n"
                               "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 0 1.25 0\n  vertex 2 0 5e-1\n"
                               " endloop\nendfacet\n"
                               "FACET NORMAL 0 0 1\n OUTER LOOP\n  VERTEX 0 0 0\n  VERTEX 2 0 0.5\n  VERTEX 0 0 -3\n"
                               " ENDLOOP\nENDFACET\n"
                               "facet\nvertex 0 0 0\nvertex 0 0 -3\nvertex 0 1.25 0\nendloop\n"
                               "facet\nvertex 2 0 0.5\nvertex 0 1.25 0\nvertex 0 0 -3\nendloop\nendsolid four\n";

#define PLY_HEAD                                                                                                       \
    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 4\n"                         \
    "property list uchar uint vertex_indices\nend_header\n"

static struct bytes binary_ply(bool big)
{
    struct bytes b = {.big = big};

    put_string(&b, big ? "ply\nformat binary_big_endian 1.0\n" PLY_HEAD
                       : "ply\r\nformat binary_little_endian 1.0\r\n" PLY_HEAD);
    for (int i = 0; i < 12; i++)
        put_float(&b, corners[i / 3][i % 3]);
    for (int i = 0; i < 4; i++) {
        b.at[b.length++] = 3;
        for (int k = 0; k < 3; k++)
            put_u32(&b, faces[i][k]);
    }
    return b;
}

static const char text_ply[] = "ply\nformat ascii 1.0\ncomment in \\\n" PLY_HEAD
                               "0 0 0\n2 0 .5\n0 1.25 0\n0 0 -3\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
static const char text_off[] =
    "OFF # four\n4 4 6\n0 0 0\n2 0 .5\n0 1.25 0\n0 0 -3\n3 0 2 1 255 0 0\n3 0 1 3\n3  0 3 2\n3 1 2 3\n";
static const char text_obj[] = "v 0 0 0\nv 2 0 .5\nv 0 1.25 0\nv 0 0 -3\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

/* Checks the scene of the four faces: the positions of all corners, the material, and the camera of the .obj file. */
static void check_four(struct reading *r, const struct tia_camera *camera)
{
    const struct tia_scene *s = &r->scene;
    const struct tia_mesh *m = s->meshes;

    CHECK_EQ(r->status, TIA_OK);
    CHECK(s->mesh_count == 1 && s->shape_count == 1 && s->material_count == 1 && s->light_count == TIA_MODEL_LIGHTS);
    CHECK(m->face_count == 4 && m->vertex_count == 4 && m->normal_count == 0 && m->uv_count == 0 && !m->groups);
    for (int i = 0; i < 12; i++) {
        const struct tia_corner *c = &m->faces[i / 3].corner[i % 3];
        const struct tia_vec3 *v = &m->vertices[c->vertex];
        const float *want = corners[faces[i / 3][i % 3]];
        CHECK(v->x == (tia_q16)(want[0] * ONE) && v->y == (tia_q16)(want[1] * ONE) && v->z == (tia_q16)(want[2] * ONE));
        CHECK(c->normal == TIA_NO_INDEX && c->uv == TIA_NO_INDEX);
    }
    CHECK(s->materials[0].colour.r == TIA_Q30(0.8) && s->materials[0].index == ONE && !s->materials[0].texture);
    CHECK(!memcmp(&s->camera.eye, &camera->eye, sizeof camera->eye) &&
          !memcmp(&s->camera.reference, &camera->reference, sizeof camera->reference));
    read_end(r);
}

TEST(encodings)
{
    struct reading r;
    struct bytes stl = binary_stl(), little = binary_ply(false), big = binary_ply(true);

    read_string(&r, TIA_FORMAT_OBJ, text_obj);
    const struct tia_camera camera = r.scene.camera;
    check_four(&r, &camera);
    read_bytes(&r, TIA_FORMAT_STL, &stl);
    check_four(&r, &camera);
    memcpy(stl.at, "solid", 5); /* a binary file may begin so */
    read_bytes(&r, TIA_FORMAT_STL, &stl);
    check_four(&r, &camera);
    read_string(&r, TIA_FORMAT_STL, text_stl);
    check_four(&r, &camera);
    read_bytes(&r, TIA_FORMAT_PLY, &little);
    check_four(&r, &camera);
    read_bytes(&r, TIA_FORMAT_PLY, &big);
    check_four(&r, &camera);
    read_string(&r, TIA_FORMAT_PLY, text_ply);
    check_four(&r, &camera);
    read_string(&r, TIA_FORMAT_OFF, text_off);
    check_four(&r, &camera);
}

/* A facet far from the origin: the middle of its bounds, (-9002, -8001, -7000.25), becomes the origin, and half of
 * their largest side, 2, becomes 8. */
TEST(far_away)
{
    static const float facet[9] = {-9000, -8000, -7000, -9004, -8000, -7000, -9000, -8002, -7000.5F};
    static const struct tia_vec3 want[3] = {
        {8 * ONE, 4 * ONE, ONE}, {-8 * ONE, 4 * ONE, ONE}, {8 * ONE, -4 * ONE, -ONE}};
    struct bytes b = {.length = 80};
    struct reading r;

    put_u32(&b, 1);
    b.length += 12;
    for (int k = 0; k < 9; k++)
        put_float(&b, facet[k]);
    b.length += 2;
    read_bytes(&r, TIA_FORMAT_STL, &b);
    CHECK(!r.status && r.scene.meshes[0].vertex_count == 3);
    CHECK(!r.status && !memcmp(r.scene.meshes[0].vertices, want, sizeof want));
    read_end(&r);
}

TEST(cut_off)
{
    struct bytes stl = binary_stl(), little = binary_ply(false);

    check_truncated(&(struct tia_reader){.format = TIA_FORMAT_STL, .text = (char *)stl.at, .length = stl.length});
    check_truncated(&(struct tia_reader){.format = TIA_FORMAT_PLY, .text = (char *)little.at, .length = little.length});
    check_truncated(&(struct tia_reader){.format = TIA_FORMAT_STL, .text = text_stl, .length = sizeof text_stl - 1});
    check_truncated(&(struct tia_reader){.format = TIA_FORMAT_PLY, .text = text_ply, .length = sizeof text_ply - 1});
    check_truncated(&(struct tia_reader){.format = TIA_FORMAT_OFF, .text = text_off, .length = sizeof text_off - 1});
}

/* ---- what a .ply or .off file can have besides ---- */

TEST(attributes)
{
    struct reading r;

    read_string(&r, TIA_FORMAT_PLY,
                "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                "property float nx\nproperty float ny\nproperty float nz\nproperty uchar red\nproperty uchar green\n"
                "property uchar blue\nproperty float s\nproperty float t\nelement face 1\nproperty uchar flags\n"
                "property list uchar int vertex_index\nproperty list uchar float texcoord\nend_header\n"
                "0 0 0 0 0 5 255 0 30 0 0\n1 0 0 0 3 4 255 51 30 1 -0.5\n0 1 0 0 0 -1 255 102 0 0.25 1\n"
                "7 3 0 1 2 6 0 0 1 0 1 1\n");
    CHECK_EQ(r.status, TIA_OK);
    const struct tia_mesh *m = r.scene.meshes;
    CHECK(m->normal_count == 3 && m->uv_count == 3 && m->face_count == 1);
    CHECK(m->normals[0].z == TIA_Q30_ONE && m->normals[1].y == TIA_Q30(0.6) && m->normals[1].z == TIA_Q30(0.8) &&
          m->normals[2].z == -TIA_Q30_ONE);
    CHECK(m->uvs[1].u == ONE && m->uvs[1].v == -ONE / 2 && m->uvs[2].u == ONE / 4 && m->uvs[2].v == ONE);
    for (uint32_t i = 0; i < 3; i++)
        CHECK(m->faces[0].corner[i].vertex == i && m->faces[0].corner[i].normal == i && m->faces[0].corner[i].uv == i);
    /* the means: 255, 51 and 20, of 255, with 16 bits */
    CHECK(r.scene.materials[0].colour.r == TIA_Q30_ONE);
    CHECK(r.scene.materials[0].colour.g == 51 * 65536 / 255 << 14);
    CHECK(r.scene.materials[0].colour.b == 20 * 65536 / 255 << 14);
    read_end(&r);
    read_string(&r, TIA_FORMAT_OFF,
                "STCNOFF\n3 1 0\n0 0 0 0 0 5 1 0 0 1 0 0\n1 0 0 0 3 4 1 0 0 1 1 -.5\n"
                "0 1 0 0 0 -1 1 0 0 1 .25 1\n3 0 1 2\n");
    CHECK_EQ(r.status, TIA_OK);
    m = r.scene.meshes;
    CHECK(m->normals[1].y == TIA_Q30(0.6) && m->uvs[1].v == -ONE / 2 && m->uvs[2].u == ONE / 4);
    read_end(&r);
}

/* Coordinates that are integers with signs, in both byte orders. */
TEST(integers)
{
    for (int big = 0; big < 2; big++) {
        struct bytes b = {.big = big};
        struct reading r;
        const int16_t z[] = {-3, 300, 0};
        put_string(&b, big ? "ply\nformat binary_big_endian 1.0\n" : "ply\nformat binary_little_endian 1.0\n");
        put_string(&b, "element vertex 3\nproperty char x\nproperty uchar y\nproperty short z\nelement face 1\n"
                       "property list ushort int8 vertex_index\nend_header\n");
        for (int i = 0; i < 3; i++) {
            put(&b, i == 0 ? "\377\377" : i == 1 ? "\1\0" : "\200\5", 1);
            put(&b, i == 0 ? "\377" : i == 1 ? "\0" : "\5", 1);
            put(&b, &z[i], 2);
        }
        put(&b, &(uint16_t){3}, 2);
        for (int i = 0; i < 3; i++)
            b.at[b.length++] = (unsigned char)i;
        read_bytes(&r, TIA_FORMAT_PLY, &b);
        CHECK_EQ(r.status, TIA_OK);
        const struct tia_vec3 *v = r.scene.meshes[0].vertices;
        CHECK(v[0].x == -ONE && v[0].y == 255 * ONE && v[0].z == -3 * ONE);
        CHECK(v[1].x == ONE && v[1].y == 0 && v[1].z == 300 * ONE && v[2].x == -128 * ONE && v[2].y == 5 * ONE);
        read_end(&r);
    }
}

/* A polygon with a notch: three triangles, which cover it without corner 3 being covered by that of its neighbours. */
TEST(polygons)
{
    struct reading r;
    int64_t area = 0;

    read_string(&r, TIA_FORMAT_OFF, "OFF\n5 1 0\n0 0 0\n2 0 0\n2 2 0\n1 1 0\n0 2 0\n5 0 1 2 3 4\n");
    CHECK(!r.status && r.scene.meshes[0].face_count == 3);
    for (uint32_t i = 0; i < 3; i++) {
        const struct tia_vec3 *v[3];
        for (int k = 0; k < 3; k++)
            v[k] = &r.scene.meshes[0].vertices[r.scene.meshes[0].faces[i].corner[k].vertex];
        int64_t twice =
            (int64_t)(v[1]->x - v[0]->x) * (v[2]->y - v[0]->y) - (int64_t)(v[2]->x - v[0]->x) * (v[1]->y - v[0]->y);
        CHECK(twice > 0);
        area += twice;
    }
    CHECK_EQ(area, (int64_t)6 * ONE * ONE); /* the square of 4, less the notch of 1 */
    read_end(&r);
}

/* ---- height fields ---- */

/* Three columns and two rows: heights 0 1/2 1, 1 0 0. At the middle of the upper edge the slope along x is 1, between
 * the neighbours, and along z -1/2, to the row below. */
static void check_heights(struct reading *r)
{
    CHECK_EQ(r->status, TIA_OK);
    const struct tia_mesh *m = r->scene.meshes;
    static const tia_q16 want[6][3] = {{0, 0, 0},     {ONE / 2, ONE / 2, 0}, {ONE, ONE, 0},
                                       {0, ONE, ONE}, {ONE / 2, 0, ONE},     {ONE, 0, ONE}};
    CHECK(m->vertex_count == 6 && m->face_count == 4 && m->normal_count == 6 && m->uv_count == 6);
    for (int i = 0; i < 6; i++)
        CHECK(m->vertices[i].x == want[i][0] && m->vertices[i].y == want[i][1] && m->vertices[i].z == want[i][2]);
    /* (-1, 1, 1/2) normalised is (-2/3, 2/3, 1/3) */
    CHECK(llabs(m->normals[1].x + TIA_Q30(2. / 3)) < 3 && llabs(m->normals[1].y - TIA_Q30(2. / 3)) < 3 &&
          llabs(m->normals[1].z - TIA_Q30(1. / 3)) < 3);
    CHECK(m->uvs[1].u == ONE / 2 && m->uvs[1].v == ONE && m->uvs[5].u == ONE && m->uvs[5].v == 0);
    for (uint32_t i = 0; i < 4; i++) { /* upwards: (b - a) x (c - a) has a positive y */
        const struct tia_vec3 *a = &m->vertices[m->faces[i].corner[0].vertex],
                              *b = &m->vertices[m->faces[i].corner[1].vertex],
                              *c = &m->vertices[m->faces[i].corner[2].vertex];
        CHECK((int64_t)(b->z - a->z) * (c->x - a->x) - (int64_t)(b->x - a->x) * (c->z - a->z) > 0);
    }
    read_end(r);
}

TEST(heights)
{
    struct reading r;
    struct bytes b = {.length = 0};

    read_string(&r, TIA_FORMAT_PGM, "P2 # a picture\n3 2 4\n0 2 4\n4 0\n0\n");
    check_heights(&r);
    put_string(&b, "P5\n3 2\n254\n");
    put(&b, "\0\177\376\376\0\0", 6);
    read_bytes(&r, TIA_FORMAT_PGM, &b);
    check_heights(&r);
    b.length = 0;
    put_string(&b, "P5 3 2 65534\n");
    put(&b, "\0\0\177\377\377\376\377\376\0\0\0\0", 12);
    read_bytes(&r, TIA_FORMAT_PGM, &b);
    check_heights(&r);
}

int main(void)
{
    RUN(floats);
    RUN(doubles);
    RUN(encodings);
    RUN(far_away);
    RUN(cut_off);
    RUN(attributes);
    RUN(integers);
    RUN(polygons);
    RUN(heights);
    return check_status();
}
