/* The oracle's rays against values worked out by hand: mirrors, glass, lights and their sums. */
#include "check.h"
#include "common/corpus/corpus.h"
#include "oracle/light.h"
#include "oracle/oracle.h"
#include "oracle/rays.h"

#define NEAR_BY(got, want, by)                                                                                         \
    CHECK_MSG(fabs((got) - (want)) < (by), "%s is %.17g, not %.17g", #got, (double)(got), (double)(want))
#define NEAR(got, want) NEAR_BY(got, want, 1e-9)
#define NEAR_RGB(got, red, green, blue)                                                                                \
    do {                                                                                                               \
        struct colour near_got = got;                                                                                  \
        NEAR_BY(near_got.channel[0], red, 2e-9);                                                                       \
        NEAR_BY(near_got.channel[1], green, 2e-9);                                                                     \
        NEAR_BY(near_got.channel[2], blue, 2e-9);                                                                      \
    } while (0)
#define BLACK TIA_RGB(0, 0, 0)
#define WHITE TIA_RGB(1, 1, 1)

enum { MATT, MIRROR, GLASS, RED, GREEN, GLOSS, PANE, MATERIALS };

static struct tia_material materials[MATERIALS];
static struct tia_shape shapes[3];
static struct tia_light lights[2];
static struct tia_scene scene;

/* Begins up to three shapes and two lights before black. */
static void begin(uint32_t shape_count, uint32_t light_count)
{
    memset(materials, 0, sizeof materials);
    memset(shapes, 0, sizeof shapes);
    memset(lights, 0, sizeof lights);
    materials[MATT].colour = (struct tia_rgb)TIA_RGB(0.5, 0.5, 0.5);
    materials[MIRROR].mirror = (struct tia_rgb)TIA_RGB(0.5, 0.5, 0.5);
    materials[GLASS].refraction = (struct tia_rgb)WHITE;
    materials[GLASS].index = TIA_Q16(1.5);
    materials[RED].emission = (struct tia_rgb)TIA_RGB(1, 0, 0);
    materials[GREEN].emission = (struct tia_rgb)TIA_RGB(0, 1, 0);
    materials[GLOSS].specular = (struct tia_rgb)WHITE;
    materials[GLOSS].exponent = TIA_Q16(10);
    materials[PANE].transmission = (struct tia_rgb)TIA_RGB(0.5, 0.25, 0);
    scene = (struct tia_scene){.camera = {.fov = TIA_Q16(90)},
                               .materials = materials,
                               .lights = lights,
                               .shapes = shapes,
                               .material_count = MATERIALS,
                               .light_count = light_count,
                               .shape_count = shape_count};
}

/* Returns a wall that faces the eye, at depth z. */
static struct tia_shape wall(double z, uint32_t material)
{
    return (struct tia_shape){
        .kind = TIA_PLANE, .material = material, .plane = {{0, 0, (tia_q16)(z * 65536)}, {0, 0, TIA_Q30(1)}}};
}

static struct tia_shape ball(double x, double y, double z, double radius, uint32_t material)
{
    return (struct tia_shape){
        .kind = TIA_SPHERE,
        .material = material,
        .sphere = {{(tia_q16)(x * 65536), (tia_q16)(y * 65536), (tia_q16)(z * 65536)}, (tia_q16)(radius * 65536)}};
}

static struct tia_shape slab(double z0, double z1, uint32_t material)
{
    return (struct tia_shape){.kind = TIA_BOX,
                              .material = material,
                              .box = {{TIA_Q16(-100), TIA_Q16(-100), (tia_q16)(z0 * 65536)},
                                      {TIA_Q16(100), TIA_Q16(100), (tia_q16)(z1 * 65536)}}};
}

static struct colour see(double ox, double oy, double oz, double dx, double dy, double dz)
{
    struct ray ray = {{ox, oy, oz}, unit((struct oracle_vec){dx, dy, dz})};

    return oracle_ray(&scene, ray, 0, 0);
}

/* The ray goes up at (3, -4)/5, onto the wall at z = -8 in y = 6, and back to y = 12 at z = 0. */
TEST(mirror_wall)
{
    begin(2, 0);
    shapes[0] = wall(-8, MIRROR);
    shapes[1] = ball(0, 12, 0, 0.01, RED);
    NEAR_RGB(see(0, 0, 0, 0, 3, -4), 0.5, 0, 0);
    shapes[1] = ball(0, 12.1, 0, 0.01, RED);
    NEAR_RGB(see(0, 0, 0, 0, 3, -4), 0, 0, 0);
}

/* Two facing mirrors glow: e (1 + 1/2 + 1/4 ...), one term more than the bounces of a ray. */
TEST(depth)
{
    begin(2, 0);
    materials[MIRROR].emission = (struct tia_rgb)TIA_RGB(0.25, 0, 0);
    shapes[0] = wall(-1, MIRROR);
    shapes[1] = wall(1, MIRROR);
    NEAR_RGB(see(0, 0, 0, 0, 0, -1), 0.25 * (2 - 1 / 32.0), 0, 0); /* five by default */
    scene.depth = 1;
    NEAR_RGB(see(0, 0, 0, 0, 0, -1), 0.25 * 1.5, 0, 0);
}

/* Throughputs are 1/20, 1/400, 1/8000; the next, 1/160000, is below 2^-16. */
TEST(faint_rays_end)
{
    begin(2, 0);
    scene.depth = 16;
    materials[MIRROR].mirror = (struct tia_rgb)TIA_RGB(0.05, 0.05, 0.05);
    materials[MIRROR].emission = (struct tia_rgb)TIA_RGB(0, 1, 0);
    shapes[0] = wall(-1, MIRROR);
    shapes[1] = wall(1, MIRROR);
    NEAR_RGB(see(0, 0, 0, 0, 0, -1), 0, 1 + 1 / 20.0 + 1 / 400.0 + 1 / 8000.0, 0);
}

/* At 30 degrees into glass 4 thick, sin t = 1/3. The ray leaves parallel to its old line, beside it by 4 (tan 30 - tan
 * t) across. */
TEST(slab_of_glass)
{
    double tan_t = (1 / 3.0) / sqrt(1 - 1 / 9.0), y = 5 * tan(PI / 6) + 4 * tan_t;

    begin(2, 0);
    shapes[0] = slab(-6, -2, GLASS);
    shapes[1] = ball(0, y, -9, 0.002, RED); /* 2 before and 3 behind the glass */
    NEAR_RGB(see(0, 0, 0, 0, 0.5, -sqrt(0.75)), 1, 0, 0);
    shapes[1] = ball(0, y + 0.01, -9, 0.002, RED);
    NEAR_RGB(see(0, 0, 0, 0, 0.5, -sqrt(0.75)), 0, 0, 0);
    materials[GLASS].index = TIA_Q16(1);
    shapes[1] = ball(0, 9 * tan(PI / 6), -9, 0.002, RED);
    NEAR_RGB(see(0, 0, 0, 0, 0.5, -sqrt(0.75)), 1, 0, 0);
}

/* Inside glass of index 1.5 all light is reflected beyond asin(1/1.5) = 41.810 degrees. */
TEST(total_internal_reflection)
{
    double below = 41.80 * PI / 180, above = 41.82 * PI / 180;

    begin(3, 0);
    scene.depth = 1;
    shapes[0] = slab(-2, 100, GLASS);
    shapes[1] = wall(-3, RED);
    shapes[2] = wall(50, GREEN);
    NEAR_RGB(see(0, 0, 0, 0, sin(below), -cos(below)), 1, 0, 0);
    NEAR_RGB(see(0, 0, 0, 0, sin(above), -cos(above)), 0, 1, 0);
    materials[GLASS].fresnel = true;
    NEAR_RGB(see(0, 0, 0, 0, sin(above), -cos(above)), 0, 1, 0);
}

/* The reflectance is ((n - 1)/(n + 1))^2 at normal incidence; at Brewster's angle, tan = n, only the half polarised
 * across the plane of incidence, ((n^2 - 1)/(n^2 + 1))^2; 1 at a grazing angle and beyond the critical angle. */
TEST(fresnel)
{
    NEAR(oracle_fresnel(1, 1, 1.5), 0.04);
    NEAR(oracle_fresnel(1, 1.5, 1), 0.04);
    NEAR(oracle_fresnel(1, 1, 4), 0.36);
    NEAR(oracle_fresnel(cos(atan(1.5)), 1, 1.5), 0.5 * (1.25 / 3.25) * (1.25 / 3.25));
    NEAR(oracle_fresnel(0, 1, 1.5), 1);
    NEAR(oracle_fresnel(cos(41.82 * PI / 180), 1.5, 1), 1);
    NEAR(oracle_fresnel(0.5, 1, 1), 0);
}

/* A red wall is before the pane, a green one behind it: 0.04 of the one, 0.96^2 of the other, with the light that is
 * reflected within the glass 0.96 0.04^2 0.96 more, a bounce later; red also from the back face, 0.96 0.04 0.96. */
TEST(fresnel_shares_out)
{
    begin(3, 0);
    materials[GLASS].fresnel = true;
    shapes[0] = slab(-4, -2, GLASS);
    shapes[1] = wall(-6, GREEN);
    shapes[2] = wall(3, RED);
    scene.depth = 1;
    NEAR_RGB(see(0, 0, 0, 0, 0, -1), 0.04, 0, 0);
    scene.depth = 2;
    NEAR_RGB(see(0, 0, 0, 0, 0, -1), 0.04, 0.96 * 0.96, 0);
    scene.depth = 3;
    NEAR_RGB(see(0, 0, 0, 0, 0, -1), 0.04 + 0.96 * 0.04 * 0.96, 0.96 * 0.96, 0);
    scene.depth = 4;
    NEAR_RGB(see(0, 0, 0, 0, 0, -1), 0.04 + 0.96 * 0.04 * 0.96, 0.96 * 0.96 * (1 + 0.04 * 0.04), 0);
}

/* Without Fresnel's equations both shares are the material's own; the mirror's is that of the near side. */
TEST(mirror_and_refraction)
{
    begin(3, 0);
    materials[GLASS].mirror = (struct tia_rgb)TIA_RGB(0.25, 0.25, 0.25);
    materials[GLASS].refraction = (struct tia_rgb)TIA_RGB(0.5, 0.5, 0.5);
    shapes[0] = wall(-2, GLASS);
    shapes[1] = wall(-4, GREEN);
    shapes[2] = wall(4, RED);
    NEAR_RGB(see(0, 0, 0, 0, 0, -1), 0.25, 0.5, 0);
}

/* The light is 20 degrees from the normal, the viewer on it: cos 20 and its tenth power. */
TEST(phong)
{
    double cosine = cos(20 * PI / 180);

    begin(1, 1);
    shapes[0] = wall(-2, GLOSS);
    lights[0] = (struct tia_light){.kind = TIA_DIRECTIONAL_LIGHT,
                                   .emission = TIA_RGB(1, 0.5, 0),
                                   .direction = {0, TIA_Q30(-0.3420201433256687), TIA_Q30(-0.9396926207859084)}};
    NEAR_RGB(see(0, 0, 0, 0, 0, -1), pow(cosine, 10), pow(cosine, 10) / 2, 0);
    materials[GLOSS].colour = (struct tia_rgb)TIA_RGB(0, 0.5, 0);
    NEAR_RGB(see(0, 0, 0, 0, 0, -1), pow(cosine, 10), (pow(cosine, 10) + 0.5 * cosine) / 2, 0);
    NEAR_RGB(see(0, 0, 0, 0, -0.3420201433256687, -0.9396926207859084), pow(cos(40 * PI / 180), 10),
             (pow(cos(40 * PI / 180), 10) + 0.5 * cosine) / 2,
             0); /* the viewer 20 degrees above, the mirror image below */
}

/* The viewer is 60 degrees from the normal, on either side: cos 60. */
TEST(facing_ratio)
{
    begin(1, 0);
    materials[MATT].facing = (struct tia_rgb)TIA_RGB(1, 0.5, 0);
    shapes[0] = wall(-2, MATT);
    NEAR_RGB(see(0, 0, 0, sqrt(0.75), 0, -0.5), 0.5, 0.25, 0);
    NEAR_RGB(see(0, 0, -4, sqrt(0.75), 0, 0.5), 0.5, 0.25, 0);
}

/* An inclined interpolated normal is used for shading; the face's plane decides which lights contribute. */
TEST(smooth_normals)
{
    static const struct tia_vec3 vertices[] = {TIA_VEC3(-9, -9, -2), TIA_VEC3(9, -9, -2), TIA_VEC3(0, 9, -2)};
    static const struct tia_dir3 normals[] = {{TIA_Q30(0.6), 0, TIA_Q30(0.8)}};
    static const struct tia_face faces[] = {{{{0, 0, TIA_NO_INDEX}, {1, 0, TIA_NO_INDEX}, {2, 0, TIA_NO_INDEX}}}};
    static const struct tia_mesh mesh = {vertices, normals, NULL, faces, 3, 1, 0, 1, NULL};

    begin(1, 1);
    scene.meshes = &mesh;
    scene.mesh_count = 1;
    shapes[0] = (struct tia_shape){.kind = TIA_MESH, .material = MATT};
    lights[0] = (struct tia_light){
        .kind = TIA_DIRECTIONAL_LIGHT, .emission = WHITE, .direction = {TIA_Q30(-0.6), 0, TIA_Q30(-0.8)}};
    NEAR_RGB(see(0, 0, 0, 0, 0, -1), 0.5, 0.5, 0.5);
    lights[0].direction = (struct tia_dir3){TIA_Q30(-0.8), 0, TIA_Q30(0.6)}; /* from behind the face: N.L = 0 */
    NEAR_RGB(see(0, 0, 0, 0, 0, -1), 0, 0, 0);
    materials[MATT].transmission = (struct tia_rgb)WHITE; /* so that the face's own shadow does not hide it */
    lights[0].direction = (struct tia_dir3){TIA_Q30(-1), 0, TIA_Q30(0.1)}; /* N.L > 0 */
    NEAR_RGB(see(0, 0, 0, 0, 0, -1), 0, 0, 0);
    lights[0].direction = (struct tia_dir3){TIA_Q30(-0.6), 0, TIA_Q30(0.8)}; /* the back: the normal is negated */
    NEAR_RGB(see(0, 0, -4, 0, 0, 1), 0.5 * 0.28, 0.5 * 0.28, 0.5 * 0.28);
}

/* A mirror with the interpolated normal (0.6, 0, 0.8) turns (0, 0, -1) into (0.96, 0, 0.28). */
TEST(smooth_mirror)
{
    static const struct tia_vec3 vertices[] = {TIA_VEC3(-9, -9, -2), TIA_VEC3(9, -9, -2), TIA_VEC3(0, 9, -2)};
    static const struct tia_dir3 normals[] = {{TIA_Q30(0.6), 0, TIA_Q30(0.8)}};
    static const struct tia_face faces[] = {{{{0, 0, TIA_NO_INDEX}, {1, 0, TIA_NO_INDEX}, {2, 0, TIA_NO_INDEX}}}};
    static const struct tia_mesh mesh = {vertices, normals, NULL, faces, 3, 1, 0, 1, NULL};

    begin(2, 0);
    scene.meshes = &mesh;
    scene.mesh_count = 1;
    shapes[0] = (struct tia_shape){.kind = TIA_MESH, .material = MIRROR};
    shapes[1] = ball(9.6, 0, 0.8, 0.01, RED);
    NEAR_RGB(see(0, 0, 0, 0, 0, -1), 0.5, 0, 0);
}

/* The hash is FNV-1a over the words 0, 0, 1, 0 for an object, its only part, and the first of two lights, which reaches
 * it, then the background in the mirror; alone, the second light. */
TEST(path)
{
    struct tia_scene alone;
    uint32_t want = UINT32_C(2166136261), words[] = {0, 0, 1, 0, TIA_NO_OBJECT, TIA_NO_OBJECT - 2};

    begin(1, 2);
    shapes[0] = wall(-2, MIRROR);
    lights[0] = (struct tia_light){.centre = TIA_VEC3(0, 5, 0), .emission = WHITE};
    lights[1] = (struct tia_light){.centre = TIA_VEC3(0, 5, -5), .emission = WHITE};
    for (int i = 0; i < 20; i++)
        want = (want ^ (words[i / 4] >> i % 4 * 8 & 255)) * 16777619u;
    CHECK_EQ(oracle_look(&scene, 1, 1, 0, 0).path_hash, want);
    alone = scene;
    alone.shape_count = 0;
    alone.lights = lights;
    lights[1] = (struct tia_light){.kind = TIA_DISC_LIGHT,
                                   .centre = TIA_VEC3(0, 0, -3),
                                   .radius = TIA_Q16(1),
                                   .emission = TIA_RGB(1, 0, 1),
                                   .direction = {0, 0, TIA_Q30(1)}};
    want = UINT32_C(2166136261);
    for (int i = 0; i < 4; i++)
        want = (want ^ (words[5] >> i % 4 * 8 & 255)) * 16777619u;
    struct oracle_pixel p = oracle_pixel(&alone, 1, 1, 0, 0, false);
    CHECK_EQ(p.path_hash, want);
    CHECK_EQ(p.object, 1);
    CHECK_EQ(p.sphere, TIA_NO_OBJECT);
    CHECK_EQ(p.colour, 0xf81f);
    NEAR(p.depth, 3);
}

/* Both halves of the oracle draw the spheres of the thesis: an up vector needs rays. */
TEST(rays_and_the_plain_formulas_agree)
{
    static struct corpus_scene c;

    for (unsigned i = 0; i < 12; i++) {
        corpus_random(&c, 1, i);
        struct tia_scene general = c.scene;
        general.camera.up = (struct tia_vec3)TIA_VEC3(0, 1, 0);
        general.camera.reference = c.scene.camera.eye;
        general.camera.reference.z -= TIA_Q16(1);
        for (unsigned k = 0; k < 900; k++) {
            unsigned x = k % 30 * c.width / 30, y = k / 30 * c.height / 30;
            struct oracle_pixel plain = oracle_pixel(&c.scene, c.width, c.height, x, y, false);
            struct oracle_pixel rays = oracle_pixel(&general, c.width, c.height, x, y, false);
            CHECK_EQ(rays.object, plain.object);
            CHECK_EQ(rays.sphere, plain.sphere);
            for (int n = 0; n < 3; n++)
                NEAR_BY(rays.linear[n], fmin(plain.linear[n], 1), 1e-6);
        }
    }
}

int main(void)
{
    RUN(mirror_wall);
    RUN(depth);
    RUN(faint_rays_end);
    RUN(slab_of_glass);
    RUN(total_internal_reflection);
    RUN(fresnel);
    RUN(fresnel_shares_out);
    RUN(mirror_and_refraction);
    RUN(phong);
    RUN(facing_ratio);
    RUN(smooth_normals);
    RUN(smooth_mirror);
    RUN(path);
    RUN(rays_and_the_plain_formulas_agree);
    return check_status();
}
