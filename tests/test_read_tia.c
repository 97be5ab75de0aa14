/* Every statement of a .tia file against its values, written down by hand. */
#include "reading.h"

#include <tia/port.h>
#include <tia/tia.h>

static struct reading now;
static const struct tia_scene *const scene = &now.scene;

static void read_text(const char *text)
{
    read_end(&now);
    now = (struct reading){.reader = {.format = TIA_FORMAT_TIA, .text = text, .length = strlen(text)}};
    read_begin(&now);
}

static void check_reads(const char *text)
{
    read_text(text);
    CHECK_MSG(!now.status, "%d, %u:%u: %s", now.status, (unsigned)now.reader.error.line,
              (unsigned)now.reader.error.column, now.reader.error.text);
}

#define SOME "material m colour 0.5\n"

static bool is_vec3(struct tia_vec3 v, double x, double y, double z)
{
    return v.x == TIA_Q16(x) && v.y == TIA_Q16(y) && v.z == TIA_Q16(z);
}

static bool is_dir3(struct tia_dir3 v, double x, double y, double z)
{
    return labs(v.x - TIA_Q30(x)) <= 2 && labs(v.y - TIA_Q30(y)) <= 2 && labs(v.z - TIA_Q30(z)) <= 2;
}

static bool is_rgb(struct tia_rgb c, double r, double g, double b)
{
    return c.r == TIA_Q30(r) && c.g == TIA_Q30(g) && c.b == TIA_Q30(b);
}

TEST(nothing_is_a_scene)
{
    check_reads("");
    CHECK(scene->camera.fov == TIA_Q16(25) && is_vec3(scene->camera.eye, 0, 0, 0) &&
          is_rgb(scene->background, 0, 0, 0));
    CHECK(scene->sphere_count == 0 && scene->shape_count == 0 && scene->light_count == 0 && !scene->depth);
    CHECK(!scene->camera.samples && !scene->bvh);
    check_reads("# only a comment");
}

TEST(cameras)
{
    check_reads("camera eye 1 2 -3.5 fov 40\nsamples 4\nbackground 0.25 0.5 1\ndepth 7");
    CHECK(is_vec3(scene->camera.eye, 1, 2, -3.5) && scene->camera.fov == TIA_Q16(40) && scene->camera.samples == 4);
    CHECK(scene->camera.projection == TIA_PERSPECTIVE && is_vec3(scene->camera.up, 0, 0, 0) && scene->depth == 7);
    CHECK(is_rgb(scene->background, 0.25, 0.5, 1));
    check_reads("camera perspective look 0 0 -9 eye 0 5 0");
    CHECK(is_vec3(scene->camera.reference, 0, 0, -9) && is_vec3(scene->camera.up, 0, 1, 0));
    CHECK(scene->camera.fov == TIA_Q16(25));
    check_reads("camera frustum eye 1 0 0 look 0 0 0 up 0 0 1 window -1 2 -0.5 0.75 near 1.5\nsamples 16");
    CHECK(scene->camera.projection == TIA_FRUSTUM && is_vec3(scene->camera.up, 0, 0, 1) && scene->camera.samples == 16);
    CHECK(scene->camera.window.left == TIA_Q16(-1) && scene->camera.window.right == TIA_Q16(2));
    CHECK(scene->camera.window.bottom == TIA_Q16(-0.5) && scene->camera.window.top == TIA_Q16(0.75));
    CHECK(scene->camera.window.near == TIA_Q16(1.5));
    check_reads("camera orthographic window 0 0 -4 4\nsamples 1");
    CHECK(scene->camera.projection == TIA_ORTHOGRAPHIC && scene->camera.window.top == TIA_Q16(4));
    CHECK(scene->camera.samples == 1);
}

TEST(materials)
{
    const struct tia_material *m;

    check_reads(
        "material a colour 1 0.5 0.25 texture t specular 0.5 exponent 10.5 mirror 0.1 refraction 0.9 index 1.25 "
        "fresnel transmission 0 0 1 emission 0.3 facing 0.2\n"
        "material b specular 1 refraction 1\nmaterial c\n"
        "texture other checker\ntexture t checker even 0.1 odd 0.2 0.3 0.4 repeat 3\n"
        "texture lying checker offset 0.5 -2 scale 4 0.3\n");
    m = scene->materials;
    CHECK(scene->material_count == 3 && is_rgb(m[0].colour, 1, 0.5, 0.25) && m[0].texture == 2);
    CHECK(is_rgb(m[0].specular, 0.5, 0.5, 0.5) && m[0].exponent == TIA_Q16(10.5) && is_rgb(m[0].mirror, 0.1, 0.1, 0.1));
    CHECK(is_rgb(m[0].refraction, 0.9, 0.9, 0.9) && m[0].index == TIA_Q16(1.25) && m[0].fresnel);
    CHECK(is_rgb(m[0].transmission, 0, 0, 1) && is_rgb(m[0].emission, 0.3, 0.3, 0.3) &&
          is_rgb(m[0].facing, 0.2, 0.2, 0.2));
    CHECK(m[1].exponent == TIA_Q16(32) && m[1].index == TIA_Q16(1.5) && !m[1].texture && !m[1].fresnel);
    CHECK(is_rgb(m[2].colour, 0, 0, 0) && !m[2].exponent && !m[2].index);
    CHECK(scene->texture_count == 3 && scene->textures[1].kind == TIA_CHECKER);
    CHECK(is_rgb(scene->textures[0].cells[0], 1, 1, 1) && is_rgb(scene->textures[0].cells[1], 0, 0, 0));
    CHECK(is_rgb(scene->textures[1].cells[0], 0.1, 0.1, 0.1) && is_rgb(scene->textures[1].cells[1], 0.2, 0.3, 0.4));
    CHECK(scene->textures[0].repeat[0] == TIA_Q16_ONE && scene->textures[1].repeat[1] == TIA_Q16(3));
    CHECK(!scene->textures[1].offset[0] && !scene->textures[1].offset[1]);
    CHECK(scene->textures[2].offset[0] == TIA_Q16(0.5) && scene->textures[2].offset[1] == TIA_Q16(-2));
    CHECK(scene->textures[2].repeat_bits == 12 && scene->textures[2].repeat[0] == 1 << 26);
    CHECK_EQ(scene->textures[2].repeat[1], 894784853); /* 2^28/0.3 */
}

TEST(spheres)
{
    const struct tia_transform *t;

    check_reads("sphere radius 3 material m\nsphere centre 0 1 2 radius 0.5 material n name still\n"
                "sphere radius 1 material m at 5 6 7\nsphere radius 1 scale 1 2 3 material n rotate 10 20 30\n"
                "sphere radius 2 material m scale 0.5\nmaterial n\nmaterial m");
    CHECK(scene->sphere_count == 2 && scene->shape_count == 3 && scene->transform_count == 3);
    CHECK(scene->spheres[0].radius == TIA_Q16(3) && scene->spheres[0].material == 1);
    CHECK(is_vec3(scene->spheres[1].centre, 0, 1, 2) && scene->spheres[1].material == 0);
    for (uint32_t i = 0; i < scene->shape_count; i++)
        CHECK(scene->shapes[i].kind == TIA_SPHERE && scene->shapes[i].transform == i + 1);
    CHECK(scene->shapes[1].material == 0 && scene->shapes[2].sphere.radius == TIA_Q16(2));
    t = scene->transforms;
    CHECK(is_vec3(t[0].position, 5, 6, 7) && is_vec3(t[0].rotation, 0, 0, 0) && is_vec3(t[0].scale, 1, 1, 1));
    CHECK(is_vec3(t[1].position, 0, 0, 0) && is_vec3(t[1].rotation, 10, 20, 30) && is_vec3(t[1].scale, 1, 2, 3));
    CHECK(is_vec3(t[2].scale, 0.5, 0.5, 0.5));
}

TEST(shapes)
{
    const struct tia_shape *s;

    check_reads(SOME "plane point 0 -1 0 normal 0 5 0 material m\n"
                     "disc centre 1 2 3 normal 0 3 4 radius 1.5 material m\n"
                     "cylinder base 0 0 0 top 0 2 0 radius 0.5 capped material m\n"
                     "cone base 0 0 0 top 0 0 3 radii 1 0 material m at 1 0 0\n"
                     "box min -1 -2 -3 max 1 2 3 material m\n"
                     "triangle a 0 0 0 b 1 0 0 c 0 1 0 material m\n");
    s = scene->shapes;
    CHECK(scene->shape_count == 6 && scene->sphere_count == 0);
    CHECK(s[0].kind == TIA_PLANE && is_vec3(s[0].plane.point, 0, -1, 0) && is_dir3(s[0].plane.normal, 0, 1, 0));
    CHECK(s[1].kind == TIA_DISC && is_vec3(s[1].disc.centre, 1, 2, 3) && is_dir3(s[1].disc.normal, 0, 0.6, 0.8));
    CHECK(s[1].disc.radius == TIA_Q16(1.5) && !s[1].transform);
    CHECK(s[2].kind == TIA_CYLINDER && is_vec3(s[2].cylinder.top, 0, 2, 0) && s[2].cylinder.capped);
    CHECK(is_vec3(s[2].cylinder.base, 0, 0, 0) && s[2].cylinder.radius == TIA_Q16(0.5));
    CHECK(s[3].kind == TIA_CONE && is_vec3(s[3].cone.top, 0, 0, 3) && s[3].cone.base_radius == TIA_Q16_ONE);
    CHECK(s[3].cone.top_radius == 0 && !s[3].cone.capped && s[3].transform == 1);
    CHECK(s[4].kind == TIA_BOX && is_vec3(s[4].box.min, -1, -2, -3) && is_vec3(s[4].box.max, 1, 2, 3));
    CHECK(s[5].kind == TIA_TRIANGLE && is_vec3(s[5].triangle.corner[1], 1, 0, 0));
    CHECK(is_vec3(s[5].triangle.corner[0], 0, 0, 0) && is_vec3(s[5].triangle.corner[2], 0, 1, 0));
}

TEST(meshes)
{
    const struct tia_mesh *m;

    check_reads(
        SOME
        "mesh one\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nnormal 1 0 0\nuv 5 6\nface 1 2 3\nend\n"
        "instance two material m at 0 0 -5\ninstance one material m\n"
        "mesh two # a quadrilateral\nvertex 0 0 0\n vertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\n"
        "normal 0 0 2\nuv 0 0.5\nuv 1 0\nface 1/1/1 2/2/1 3/1/1 4/2/1\nface 4//1 2//1 1//1\nface 1/2 2/1 3/1\nend\n");
    m = scene->meshes;
    CHECK(scene->mesh_count == 2 && m[0].vertex_count == 3 && m[0].face_count == 1 && m[0].normal_count == 1 &&
          m[0].uv_count == 1);
    CHECK(is_vec3(m[0].vertices[2], 0, 1, 0) && m[0].faces[0].corner[2].vertex == 2);
    CHECK(m[0].faces[0].corner[0].normal == TIA_NO_INDEX && m[0].faces[0].corner[0].uv == TIA_NO_INDEX);
    CHECK(m[1].vertex_count == 4 && m[1].face_count == 4 && m[1].normal_count == 1 && m[1].uv_count == 2);
    CHECK(is_dir3(m[1].normals[0], 0, 0, 1) && m[1].uvs[0].v == TIA_Q16(0.5) && m[1].uvs[1].u == TIA_Q16_ONE);
    CHECK(is_vec3(m[1].vertices[2], 1, 1, 0));
    const struct tia_corner *c = m[1].faces[1].corner; /* the second triangle of the fan */
    CHECK(c[0].vertex == 0 && c[1].vertex == 2 && c[2].vertex == 3 && c[2].uv == 1 && c[2].normal == 0);
    c = m[1].faces[2].corner;
    CHECK(c[0].vertex == 3 && c[0].normal == 0 && c[0].uv == TIA_NO_INDEX);
    c = m[1].faces[3].corner;
    CHECK(c[0].uv == 1 && c[0].normal == TIA_NO_INDEX);
    CHECK(scene->shape_count == 2 && scene->shapes[0].kind == TIA_MESH && scene->shapes[0].mesh == 1);
    CHECK(scene->shapes[1].mesh == 0 && scene->shapes[0].transform == 1 && !scene->shapes[1].transform);
}

TEST(grids)
{
    const struct tia_grid *g;
    static const uint8_t cells[12] = {1, 0, 1, 0, 1, 0, 2, 2, 2, 0, 0, 255};

    check_reads("grid small size 1 1 1 cell 0.5\nrow 1\nend\n"
                "grid g size 3 2 2 corner -1 0 1\nrow 1 0 1\nrow 0 1 0\nrow 2 2 2\nrow 0 0 255\nend\n");
    g = scene->grids;
    CHECK(scene->grid_count == 2 && g[0].cell == TIA_Q16(0.5) && g[0].cells[0] == 1 && is_vec3(g[0].corner, 0, 0, 0));
    CHECK(g[1].size[0] == 3 && g[1].size[1] == 2 && g[1].size[2] == 2 && g[1].cell == TIA_Q16_ONE);
    CHECK(is_vec3(g[1].corner, -1, 0, 1) && memcmp(g[1].cells, cells, sizeof cells) == 0);
    check_reads(SOME "grid g size 1 1 1\nrow 1\nend\ninstance g material m scale 2");
    CHECK(scene->shapes[0].kind == TIA_GRID && scene->shapes[0].grid == 0 && scene->shapes[0].transform == 1);
}

TEST(lights)
{
    const struct tia_light *l;

    check_reads("light at 1 2 3\nlight point at 0 5 0 radius 3 emission 1.5 1 0.5 attenuation 1 0.5 0.25\n"
                "light directional direction 0 -2 0 emission 0.5\nlight ambient emission 0.1\n"
                "light spot at 0 5 0 direction 0 -1 0 inner 20 outer 30\n"
                "light rectangle at 0 5 0 sides 1 0 0 0 0 2 samples 64\n"
                "light disc at 0 5 0 direction 3 -4 0 radius 0.5\nlight sphere at 0 5 0 radius 2 samples 256\n");
    l = scene->lights;
    CHECK(scene->light_count == 8);
    for (uint32_t i = 0; i < scene->light_count; i++)
        CHECK_EQ(l[i].kind, i ? i - 1 : 0);
    CHECK(is_vec3(l[0].centre, 1, 2, 3) && is_rgb(l[0].emission, 1, 1, 1) && !l[0].radius && !l[0].constant);
    CHECK(l[1].radius == TIA_Q16(3) && is_rgb(l[1].emission, 1.5, 1, 0.5) && l[1].constant == TIA_Q16_ONE);
    CHECK(l[1].linear == TIA_Q16(0.5) && l[1].quadratic == TIA_Q16(0.25));
    CHECK(is_dir3(l[2].direction, 0, -1, 0) && is_rgb(l[3].emission, 0.1, 0.1, 0.1));
    CHECK(l[4].inner == TIA_Q16(20) && l[4].outer == TIA_Q16(30) && is_dir3(l[4].direction, 0, -1, 0));
    CHECK(is_vec3(l[5].side[0], 1, 0, 0) && is_vec3(l[5].side[1], 0, 0, 2) && l[5].samples == 64);
    CHECK(is_dir3(l[6].direction, 0.6, -0.8, 0) && l[6].radius == TIA_Q16(0.5) && !l[6].samples);
    CHECK(l[7].radius == TIA_Q16(2) && l[7].samples == 256);
}

/* Emission above 1, or a light's above 2, gets the powers of 2 that it needs. */
TEST(bright_emission)
{
    check_reads("material a emission 1\nmaterial b emission 1.5 0.5 0\nmaterial c emission 12 8 7\n"
                "material d emission 8192 1 0\nlight at 0 1 0 emission 1.5\nlight at 0 1 0 emission 2\n"
                "light at 0 1 0 emission 16383 1 0.5\nlight at 0 1 0 emission 16383.9999999\n");
    CHECK(is_rgb(scene->materials[0].emission, 1, 1, 1) && scene->materials[0].emission_bits == 0);
    CHECK(is_rgb(scene->materials[1].emission, 0.75, 0.25, 0) && scene->materials[1].emission_bits == 1);
    CHECK(is_rgb(scene->materials[2].emission, 0.75, 0.5, 0.4375) && scene->materials[2].emission_bits == 4);
    CHECK(is_rgb(scene->lights[0].emission, 1.5, 1.5, 1.5) && scene->lights[0].emission_bits == 0);
    CHECK(is_rgb(scene->lights[1].emission, 1, 1, 1) && scene->lights[1].emission_bits == 1);
    CHECK(is_rgb(scene->materials[3].emission, 1, 1.0 / 8192, 0) && scene->materials[3].emission_bits == 13);
    CHECK(scene->lights[2].emission_bits == 13 && scene->lights[2].emission.g == TIA_Q30_ONE >> 13);
    CHECK(scene->lights[3].emission_bits == 13 && scene->lights[3].emission.g == INT32_MAX);
}

TEST(integrators)
{
    check_reads("integrator path\nspp 16777216\ntone linear\nexposure -1.5\n");
    CHECK(scene->integration.integrator == TIA_PATHS && scene->integration.spp == TIA_SPP_MAX);
    CHECK(scene->integration.tone == TIA_TONE_LINEAR && scene->integration.exposure == TIA_Q16(-1.5));
    check_reads("integrator ao 2.5\nlight ambient occlusion 3 samples 64\n");
    CHECK(scene->integration.integrator == TIA_OCCLUSION && scene->integration.distance == TIA_Q16(2.5));
    CHECK(scene->lights[0].radius == TIA_Q16(3) && scene->lights[0].samples == 64);
    check_reads("integrator ao\n");
    CHECK(scene->integration.integrator == TIA_OCCLUSION && scene->integration.distance == 0);
}

TEST(keys)
{
    const struct tia_binding *b;

    check_reads("key a light 1 at -20 20 -20 radius 3\nkey 7 light 65536 spot at 0 5 0 direction 0 -1 0 outer 30\n"
                "key page-down light 2 ambient emission 0.5");
    b = scene->bindings;
    CHECK(scene->binding_count == 3 && b[0].key == 'a' && b[0].light == 0 && is_vec3(b[0].state.centre, -20, 20, -20));
    CHECK(b[0].state.radius == TIA_Q16(3) && is_rgb(b[0].state.emission, 1, 1, 1));
    CHECK(b[1].key == '7' && b[1].light == 65535 && b[1].state.kind == TIA_SPOT_LIGHT);
    CHECK(b[2].key == TIA_KEY_PAGE_DOWN && b[2].light == 1 && b[2].state.kind == TIA_AMBIENT_LIGHT);
}

static void tia_check_track(uint32_t i, enum tia_target target, uint32_t index, bool smooth, uint32_t keys)
{
    const struct tia_track *t = &scene->tracks[i];
    CHECK_MSG(t->target == target && t->index == index && t->smooth == smooth && t->key_count == keys, "track %u",
              (unsigned)i);
}

TEST(motion)
{
    check_reads(SOME
                "animate ball at smooth 0: 0 0 0  2: 0 3 0\nanimate ball rotate 0.5: 0 0 0 1: 0 360 0 \\\n 1.5: 1 2 3\n"
                "animate egg scale linear 0: 1 2: 1 2 3 4: 2\n"
                "sphere radius 1 material m\nsphere radius 1 material m at 0 0 -9\n"
                "sphere centre 0 0 -5 radius 1 material m name ball\n"
                "box min 0 0 0 max 1 1 1 material m name egg\nbox min 0 0 0 max 1 1 1 material m name other\n"
                "light ambient\nlight at 0 5 0 name lamp\nlight directional direction 0 -1 0 name sun\n"
                "animate lamp at 1: 1 1 1\nanimate sun direction 0: 1 0 0 3: 0 1 0\n"
                "animate camera eye 0: 0 0 1\nanimate camera look smooth 1: 0 0 0\n"
                "camera eye 0 0 1 look 0 0 -9");
    CHECK(scene->sphere_count == 1 && scene->shape_count == 4 && scene->transform_count == 3);
    CHECK(scene->shapes[1].transform == 2 && is_vec3(scene->shapes[1].sphere.centre, 0, 0, -5));
    CHECK(scene->shapes[2].transform == 3 && scene->shapes[3].transform == 0);
    CHECK(is_vec3(scene->transforms[2].scale, 1, 1, 1) && scene->track_count == 7);
    tia_check_track(0, TIA_MOVES_TRANSFORM, 1, true, 2);
    tia_check_track(1, TIA_ROTATES_TRANSFORM, 1, false, 3);
    tia_check_track(2, TIA_SCALES_TRANSFORM, 2, false, 3);
    tia_check_track(3, TIA_MOVES_LIGHT, 1, false, 1);
    tia_check_track(4, TIA_ROTATES_LIGHT, 2, false, 2);
    tia_check_track(5, TIA_MOVES_EYE, 0, false, 1);
    tia_check_track(6, TIA_MOVES_REFERENCE, 0, true, 1);
    const struct tia_keyframe *k = scene->tracks[1].keys;
    CHECK(k[0].time == TIA_Q16(0.5) && k[1].time == TIA_Q16_ONE && is_vec3(k[1].value, 0, 360, 0));
    CHECK(k[2].time == TIA_Q16(1.5) && is_vec3(k[2].value, 1, 2, 3));
    k = scene->tracks[2].keys;
    CHECK(is_vec3(k[0].value, 1, 1, 1) && is_vec3(k[1].value, 1, 2, 3) && is_vec3(k[2].value, 2, 2, 2));
    CHECK(scene->tracks[0].keys[1].time == TIA_Q16(2) && scene->tracks[0].keys[1].value.y == TIA_Q16(3));
}

TEST(a_camera_that_is_told_where_to_look)
{
    check_reads("animate camera look 1: 1 2 -3 2: 0 0 -9\ncamera eye 0 0 5");
    CHECK(is_vec3(scene->camera.reference, 1, 2, -3) && is_vec3(scene->camera.up, 0, 1, 0));
    check_reads("animate camera look 1: 1 2 -3 2: 0 0 -9\ncamera look 5 6 -7 up 1 0 0");
    CHECK(is_vec3(scene->camera.reference, 5, 6, -7) && is_vec3(scene->camera.up, 1, 0, 0));
    check_reads("animate camera eye 1: 1 2 -3");
    CHECK(is_vec3(scene->camera.up, 0, 0, 0));
}

static bool is_rgb_of(struct tia_rgb a, struct tia_rgb b)
{
    return a.r == b.r && a.g == b.g && a.b == b.b;
}

static bool is_vec3_of(struct tia_vec3 a, struct tia_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

static void check_same_light(const struct tia_light *a, const struct tia_light *b)
{
    CHECK(a->kind == b->kind && is_vec3_of(a->centre, b->centre) && a->radius == b->radius);
    CHECK(is_rgb_of(a->emission, b->emission) && a->direction.x == b->direction.x && a->direction.y == b->direction.y);
    CHECK(a->direction.z == b->direction.z && a->inner == b->inner && a->outer == b->outer);
    CHECK(is_vec3_of(a->side[0], b->side[0]) && is_vec3_of(a->side[1], b->side[1]) && a->samples == b->samples);
    CHECK(a->constant == b->constant && a->linear == b->linear && a->quadratic == b->quadratic);
}

static void check_same_material(const struct tia_material *a, const struct tia_material *b)
{
    CHECK(is_rgb_of(a->colour, b->colour) && is_rgb_of(a->transmission, b->transmission));
    CHECK(is_rgb_of(a->emission, b->emission) && is_rgb_of(a->specular, b->specular) && a->exponent == b->exponent);
    CHECK(is_rgb_of(a->mirror, b->mirror) && is_rgb_of(a->refraction, b->refraction) && a->index == b->index);
    CHECK(a->fresnel == b->fresnel && is_rgb_of(a->facing, b->facing) && a->texture == b->texture);
}

static void check_same_camera(const struct tia_camera *a, const struct tia_camera *b)
{
    CHECK(is_vec3_of(a->eye, b->eye) && a->fov == b->fov && a->projection == b->projection);
    CHECK(is_vec3_of(a->reference, b->reference) && is_vec3_of(a->up, b->up) && a->samples == b->samples);
    CHECK(a->window.left == b->window.left && a->window.right == b->window.right && a->window.top == b->window.top);
    CHECK(a->window.bottom == b->window.bottom && a->window.near == b->window.near);
}

TEST(the_thesis_scene)
{
    const struct tia_scene *want = &tia_thesis_scene;
    size_t length;
    char *text = load_file("scenes/thesis.tia", &length);

    CHECK(text);
    if (!text)
        return;
    check_reads(text);
    free(text);
    check_same_camera(&scene->camera, &want->camera);
    CHECK(is_rgb_of(scene->background, want->background) && scene->depth == want->depth && scene->bvh == want->bvh);
    CHECK(scene->material_count == want->material_count && scene->sphere_count == want->sphere_count);
    CHECK(scene->light_count == want->light_count && scene->binding_count == want->binding_count);
    CHECK(!scene->shape_count && !scene->transform_count && !scene->texture_count && !scene->mesh_count);
    CHECK(!scene->grid_count && !scene->track_count);
    for (uint32_t i = 0; i < want->material_count; i++)
        check_same_material(&scene->materials[i], &want->materials[i]);
    for (uint32_t i = 0; i < want->sphere_count; i++) {
        CHECK(is_vec3_of(scene->spheres[i].centre, want->spheres[i].centre));
        CHECK(scene->spheres[i].radius == want->spheres[i].radius);
        CHECK(scene->spheres[i].material == want->spheres[i].material);
    }
    for (uint32_t i = 0; i < want->binding_count; i++) {
        CHECK(scene->bindings[i].key == want->bindings[i].key && scene->bindings[i].light == want->bindings[i].light);
        check_same_light(&scene->bindings[i].state, &want->bindings[i].state);
    }
}

int main(void)
{
    RUN(nothing_is_a_scene);
    RUN(cameras);
    RUN(materials);
    RUN(spheres);
    RUN(shapes);
    RUN(meshes);
    RUN(grids);
    RUN(lights);
    RUN(bright_emission);
    RUN(integrators);
    RUN(keys);
    RUN(motion);
    RUN(a_camera_that_is_told_where_to_look);
    RUN(the_thesis_scene);
    read_end(&now);
    return check_status();
}
