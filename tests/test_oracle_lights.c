/* The oracle's lights, textures and cameras against values worked out by hand. */
#include "check.h"
#include "oracle/light.h"
#include "oracle/oracle.h"
#include "oracle/rays.h"

#define NEAR_BY(got, want, by)                                                                                         \
    CHECK_MSG(fabs((got) - (want)) < (by), "%s is %.17g, not %.17g", #got, (double)(got), (double)(want))
#define NEAR(got, want) NEAR_BY(got, want, 1e-9)
#define NEAR_VEC(got, ...)                                                                                             \
    do {                                                                                                               \
        struct oracle_vec near_got = got, near_want = {__VA_ARGS__};                                                   \
        CHECK_MSG(length(sub(near_got, near_want)) < 1e-9, "%s is %.9g %.9g %.9g", #got, near_got.x, near_got.y,       \
                  near_got.z);                                                                                         \
    } while (0)
#define WHITE TIA_RGB(1, 1, 1)

static const struct oracle_vec origin = {0, 0, 0};

static struct tia_material materials[3];
static struct tia_shape shapes[3];
static struct tia_light light;
static struct tia_scene scene;

/* Begins a white floor y = 0, the eye at (0, 1, 0) and a light; material 1 is red glass to shadow rays, 2 is opaque. */
static void begin(enum tia_light_kind kind)
{
    memset(materials, 0, sizeof materials);
    memset(shapes, 0, sizeof shapes);
    light = (struct tia_light){.kind = kind, .centre = TIA_VEC3(0, 4, 0), .emission = WHITE};
    light.direction = (struct tia_dir3){0, TIA_Q30(-1), 0};
    materials[0].colour = (struct tia_rgb)WHITE;
    materials[1].transmission = (struct tia_rgb)TIA_RGB(0.5, 0.25, 0);
    shapes[0] = (struct tia_shape){.kind = TIA_PLANE, .plane = {TIA_VEC3(0, 0, 0), {0, TIA_Q30(1), 0}}};
    scene = (struct tia_scene){
        .materials = materials, .lights = &light, .shapes = shapes, .material_count = 3, .light_count = 1};
    scene.shape_count = 1;
}

/* Returns the colour of the floor at (x, 0, z), seen from above. */
static struct colour floor_at(double x, double z)
{
    return oracle_ray(&scene, (struct ray){{x, 1, z}, {0, -1, 0}}, 0, 0);
}

static double red_at(double x, double z)
{
    return floor_at(x, z).channel[0];
}

/* Returns a box of that material over the floor, from x0 to x1, between the eye and the light. */
static struct tia_shape box(double x0, double x1, uint32_t material)
{
    return (struct tia_shape){
        .kind = TIA_BOX,
        .material = material,
        .box = {{(tia_q16)(x0 * 65536), TIA_Q16(2), TIA_Q16(-50)}, {(tia_q16)(x1 * 65536), TIA_Q16(3), TIA_Q16(50)}}};
}

/* The light is 4 above: cosine 4/5 and distance 5 at (3, 0, 0). */
TEST(point_and_attenuation)
{
    begin(TIA_POINT_LIGHT);
    NEAR(red_at(3, 0), 0.8);
    light.quadratic = TIA_Q16(1);
    NEAR(red_at(0, 0), 1 / 16.0);
    NEAR(red_at(3, 0), 0.8 / 25);
    light.constant = TIA_Q16(2);
    light.linear = TIA_Q16(0.5);
    NEAR(red_at(3, 0), 0.8 / (2 + 2.5 + 25));
    scene.scale_bits = 1; /* 2.5 of the file's units */
    NEAR(red_at(3, 0), 0.8 / (2 + 1.25 + 6.25));
}

/* The direction is (3, 4)/5: a box at any distance towards the light casts a shadow; there is no attenuation. */
TEST(directional)
{
    begin(TIA_DIRECTIONAL_LIGHT);
    light.direction = (struct tia_dir3){TIA_Q30(-0.6), TIA_Q30(-0.8), 0};
    light.quadratic = TIA_Q16(1);
    NEAR_BY(red_at(0, 0), 0.8, 2e-9);
    shapes[1] = (struct tia_shape){.kind = TIA_SPHERE, .material = 2, .sphere = {TIA_VEC3(3000, 4000, 0), TIA_Q16(1)}};
    scene.shape_count = 2;
    NEAR(red_at(0, 0), 0);
}

TEST(ambient_casts_no_shadow)
{
    begin(TIA_AMBIENT_LIGHT);
    shapes[1] = box(-1, 1, 2);
    scene.shape_count = 2;
    light.emission = (struct tia_rgb)TIA_RGB(0.25, 0, 0);
    NEAR(red_at(0, 0), 0.25);
}

/* A cone of 20 degrees inside and 40 outside, downwards: all light at 20, none at 40, linear in the cosine between. */
TEST(spot)
{
    double inner = cos(20 * PI / 180), outer = cos(40 * PI / 180), half = acos((inner + outer) / 2);

    begin(TIA_SPOT_LIGHT);
    light.inner = TIA_Q16(20);
    light.outer = TIA_Q16(40);
    NEAR(red_at(0, 0), 1);
    NEAR(red_at(4 * tan(19.9 * PI / 180), 0), cos(19.9 * PI / 180));
    NEAR(red_at(4 * tan(half), 0), cos(half) / 2);
    NEAR(red_at(0, 4 * tan(half)), cos(half) / 2);
    NEAR(red_at(4 * tan(40.01 * PI / 180), 0), 0);
    light.inner = light.outer;
    NEAR(red_at(4 * tan(39.9 * PI / 180), 0), cos(39.9 * PI / 180));
    NEAR(red_at(4 * tan(40.1 * PI / 180), 0), 0);
}

/* The segment meets a box twice, but it is one object; two boxes are two. */
TEST(transmission)
{
    begin(TIA_POINT_LIGHT);
    shapes[1] = box(-1, 1, 1);
    shapes[2] = box(-2, 2, 1);
    scene.shape_count = 2;
    struct colour c = floor_at(0, 0);
    NEAR(c.channel[0], 0.5);
    NEAR(c.channel[1], 0.25);
    NEAR(c.channel[2], 0);
    scene.shape_count = 3;
    NEAR(red_at(0, 0), 0.25);
    light.centre.y = TIA_Q16(1.5); /* both boxes are beyond the light */
    NEAR(red_at(0, 0), 1);
}

/* The pattern is u = (i + 1/2)/4 + b/16, v = 0, 1/2, 1/4, 3/4 from r(b) on; the pixel (2, 1) is of the class 14 = 1110
 * in binary, r = 0.0111 = 7/16. */
TEST(sample_pattern)
{
    static const double u[4] = {0.125, 0.375, 0.625, 0.875}, v[4] = {0, 0.5, 0.25, 0.75};
    double got_u, got_v;

    CHECK_EQ(light_class(0, 0), 0);
    CHECK_EQ(light_class(6, 5), 14);
    CHECK_EQ(light_class(3, 0), 10);
    for (unsigned i = 0; i < 4; i++) {
        light_pattern(0, i, 4, &got_u, &got_v);
        NEAR(got_u, u[i]);
        NEAR(got_v, v[i]);
        light_pattern(14, i, 4, &got_u, &got_v);
        NEAR(got_u, fmod(u[i] + 14 / 16.0, 1));
        NEAR(got_v, fmod(v[i] + 7 / 16.0, 1));
    }
}

static struct oracle_vec sample_at(unsigned pixel_class, unsigned i, struct oracle_vec p)
{
    struct beam beam;

    CHECK(light_beam(&light, 1, p, pixel_class, i, &beam));
    NEAR(beam.strength, 0.25);
    return along(p, beam.distance, beam.direction);
}

/* Sample 1 of 4 in class 0 has u = 3/8, v = 1/2. So s = -1/4, t = 0; on the disc, which faces down: e = x, A = x x -y =
 * -z, at half a turn +z times sqrt(3/8); on the sphere's disc the same, turned up to the point above: A = z. */
TEST(area_samples)
{
    begin(TIA_RECTANGLE_LIGHT);
    light.samples = 4;
    light.side[0] = (struct tia_vec3)TIA_VEC3(2, 0, 0);
    light.side[1] = (struct tia_vec3)TIA_VEC3(0, 0, 3);
    NEAR_VEC(sample_at(0, 1, origin), -0.5, 4, 0);
    NEAR_VEC(sample_at(0, 0, origin), -1.5, 4, -3);
    begin(TIA_DISC_LIGHT);
    light.samples = 4;
    light.radius = TIA_Q16(2);
    NEAR_VEC(sample_at(0, 1, origin), 0, 4, 2 * sqrt(0.375));
    begin(TIA_SPHERE_LIGHT);
    light.samples = 4;
    light.radius = TIA_Q16(2);
    NEAR_VEC(sample_at(0, 1, (struct oracle_vec){0, 9, 0}), 0, 4, -2 * sqrt(0.375));
    NEAR_VEC(sample_at(0, 2, (struct oracle_vec){0, 9, 0}), 2 * sqrt(0.625), 4, 0);
}

/* Half of the samples are behind the box, whose edge is at the middle; 16 is the default. */
TEST(soft_shadow)
{
    begin(TIA_RECTANGLE_LIGHT);
    light.centre.y = TIA_Q16(4000);
    light.side[0] = (struct tia_vec3)TIA_VEC3(1, 0, 0);
    light.side[1] = (struct tia_vec3)TIA_VEC3(0, 0, 1);
    NEAR_BY(red_at(0, 0), 1, 1e-6);
    shapes[1] = box(-9, 0, 2);
    scene.shape_count = 2;
    NEAR_BY(red_at(0, 0), 0.5, 1e-6);
    /* the box's top edge, 2 above the floor, is in front of the samples up to s = 0.49: 12 of 16 */
    shapes[1] = box(-9, 0.5 * 2 / 4000, 2);
    NEAR_BY(red_at(0, 0), 0.25, 1e-6);
}

static bool seen(double ox, double oy, double oz, double dx, double dy, double dz)
{
    struct ray ray = {{ox, oy, oz}, unit((struct oracle_vec){dx, dy, dz})};

    return oracle_ray(&scene, ray, 0, 0).channel[1] > 0.9;
}

/* Lights at (0, 4, 0) are visible from below, from above and beside their edges. */
TEST(lights_are_seen)
{
    static const enum tia_light_kind round[] = {TIA_POINT_LIGHT, TIA_SPHERE_LIGHT, TIA_DISC_LIGHT};

    for (int i = 0; i < 3; i++) {
        begin(round[i]);
        CHECK(!seen(0, 1, 0, 0, 1, 0));
        light.radius = TIA_Q16(1);
        CHECK(seen(0, 1, 0.5, 0, 1, 0) && seen(0, 9, 0.99, 0, -1, 0));
        CHECK(!seen(0, 1, 1.01, 0, 1, 0));
    }
    CHECK(!seen(0, 4.01, -5, 0, 0, 1)); /* the disc has no height */
    begin(TIA_RECTANGLE_LIGHT);
    light.side[0] = (struct tia_vec3)TIA_VEC3(2, 0, 0);
    CHECK(!seen(0, 1, 0, 0, 1, 0));
    light.side[1] = (struct tia_vec3)TIA_VEC3(1, 0, 1); /* a parallelogram */
    CHECK(seen(0, 1, 0, 0, 1, 0) && seen(2.4, 1, 0.5, 0, 1, 0) && seen(2.4, 9, 0.5, 0, -1, 0));
    CHECK(!seen(2.6, 1, 0.5, 0, 1, 0) && !seen(-2, 1, 0.5, 0, 1, 0) && !seen(0, 1, 1.1, 0, 1, 0));
    begin(TIA_SPOT_LIGHT);
    light.radius = TIA_Q16(1);
    CHECK(!seen(0, 1, 0, 0, 1, 0));
}

/* Lights cast no shadow: the light from (0, 9, 0) passes the one below it, which the floor shows as a mirror. */
TEST(lights_cast_no_shadow)
{
    struct tia_light two[2];

    begin(TIA_POINT_LIGHT);
    two[0] = two[1] = light;
    two[0].centre.y = TIA_Q16(9);
    two[1].radius = TIA_Q16(1);
    two[1].emission = (struct tia_rgb)TIA_RGB(0, 1, 0);
    scene.lights = two;
    scene.light_count = 2;
    NEAR(red_at(0, 0), 1);
    materials[0].colour = (struct tia_rgb)TIA_RGB(0, 0, 0);
    materials[0].mirror = (struct tia_rgb)WHITE;
    NEAR(floor_at(0, 0).channel[1], 1);
}

static uint32_t cell; /* texel of the last call of texture_at */

static double texture_at(const struct tia_texture *t, double u, double v)
{
    return oracle_texture(t, u, v, &cell).channel[0];
}

/* Cells are 1 x 1; floor(-0.5) + floor(0.5) = -1 is odd. The floor's u is its x, its v its -z. */
TEST(checker)
{
    struct tia_texture t = {
        .kind = TIA_CHECKER, .repeat = {TIA_Q16(1), TIA_Q16(2)}, .cells = {TIA_RGB(1, 0, 0), TIA_RGB(0.25, 0, 0)}};

    NEAR(texture_at(&t, 0.5, 0.25), 1);
    CHECK_EQ(cell, 0);
    NEAR(texture_at(&t, 0.5, 0.75), 0.25);
    CHECK_EQ(cell, 1);
    NEAR(texture_at(&t, -0.5, 0.25), 0.25);
    NEAR(texture_at(&t, -0.5, -0.25), 1);
    begin(TIA_POINT_LIGHT);
    scene.textures = &t;
    materials[0].texture = 1;
    materials[0].colour = (struct tia_rgb)TIA_RGB(0.5, 0.5, 0.5);
    light.centre = (struct tia_vec3)TIA_VEC3(-0.5, 4, -0.125);
    NEAR(red_at(-0.5, -0.125), 0.125); /* u = -0.5, 2v = 0.25 */
    light.centre.x = TIA_Q16(0.5);
    NEAR(red_at(0.5, -0.125), 0.5);
    t.offset[0] = TIA_Q16(0.75);
    NEAR(red_at(0.5, -0.125), 0.125);
    t.offset[1] = TIA_Q16(0.25);
    NEAR(red_at(0.5, -0.125), 0.5);
}

/* The image is two texels wide and high: upper row 0 255, lower row 51 102. */
TEST(image)
{
    static const uint8_t texels[12] = {0, 0, 0, 255, 0, 0, 51, 0, 0, 102, 0, 0};
    struct tia_texture t = {
        .kind = TIA_IMAGE, .repeat = {TIA_Q16(1), TIA_Q16(1)}, .width = 2, .height = 2, .texels = texels};

    NEAR(texture_at(&t, 0.1, 0.9), 0);
    NEAR(texture_at(&t, 0.9, 0.9), 1);
    NEAR(texture_at(&t, 0.1, 0.1), 0.2);
    CHECK_EQ(cell, 2);
    NEAR(texture_at(&t, -0.1, 1.1), 0.4);
    CHECK_EQ(cell, 3);
    t.bilinear = true;
    NEAR(texture_at(&t, 0.75, 0.75), 1);
    CHECK_EQ(cell, ORACLE_BLENDED);
    NEAR(texture_at(&t, 0.5, 0.75), 0.5);
    NEAR(texture_at(&t, 0.5, 0.5), (0 + 1 + 0.2 + 0.4) / 4);
    NEAR(texture_at(&t, 0.25 + 0.125, 0.75), 0.25);
    NEAR(texture_at(&t, 1, 0.75), 0.5); /* across the edge */
    t.offset[0] = TIA_Q16(-0.125);
    t.offset[1] = TIA_Q16(2.5);
    NEAR(texture_at(&t, 0.25, 3.25), 0.25);
    NEAR(texture_at(&t, 0.625, 2.75), 0.4);
}

static struct oracle_vec towards(const struct tia_camera *camera, double x, double y)
{
    return oracle_camera(camera, NULL, 4, 2, x, y).direction;
}

/* The eye looks from (0, 0, 5) to +x: n = -x, u = y x -x = z, v = -x x z = y. */
TEST(look_at)
{
    struct tia_camera c = {.eye = TIA_VEC3(0, 0, 5), .fov = TIA_Q16(90), .reference = TIA_VEC3(7, 0, 5)};

    c.up = (struct tia_vec3)TIA_VEC3(1, 3, 0);
    NEAR_VEC(towards(&c, 2, 1), 1, 0, 0);
    NEAR_VEC(towards(&c, 4, 0), 1 / sqrt(6), 1 / sqrt(6), 2 / sqrt(6));
    c.up = (struct tia_vec3)TIA_VEC3(0, 0, 0);
    NEAR_VEC(towards(&c, 4, 0), 2 / sqrt(6), 1 / sqrt(6), -1 / sqrt(6));
}

TEST(frustum)
{
    struct tia_camera c = {.projection = TIA_FRUSTUM,
                           .window = {TIA_Q16(-1), TIA_Q16(3), TIA_Q16(0), TIA_Q16(2), TIA_Q16(2)}};

    NEAR_VEC(towards(&c, 1, 2), 0, 0, -1);
    NEAR_VEC(towards(&c, 4, 0), 3 / sqrt(17), 2 / sqrt(17), -2 / sqrt(17));
    c.window.left = c.window.right = 0; /* 4 wide at a height of 2 */
    NEAR_VEC(towards(&c, 0, 0), -2 / sqrt(12), 2 / sqrt(12), -2 / sqrt(12));
}

TEST(orthographic)
{
    struct tia_camera c = {.projection = TIA_ORTHOGRAPHIC,
                           .eye = TIA_VEC3(10, 0, 0),
                           .window = {TIA_Q16(-1), TIA_Q16(3), TIA_Q16(0), TIA_Q16(2)}};

    NEAR_VEC(oracle_camera(&c, NULL, 4, 2, 0.5, 0.5).origin, 9.5, 1.5, 0);
    NEAR_VEC(oracle_camera(&c, NULL, 4, 2, 1.5, 1.5).origin, 10.5, 0.5, 0);
    NEAR_VEC(towards(&c, 0.5, 0.5), 0, 0, -1);
}

TEST(samples)
{
    static const double want[4][2] = {{0.125, 0.375}, {0.625, 0.125}, {0.375, 0.875}, {0.875, 0.625}};
    unsigned columns = 0, rows = 0;
    double x, y;

    oracle_sample(1, 0, &x, &y);
    NEAR(x, 0.5);
    NEAR(y, 0.5);
    for (unsigned i = 0; i < 4; i++) {
        oracle_sample(4, i, &x, &y);
        NEAR(x, want[i][0]);
        NEAR(y, want[i][1]);
    }
    for (unsigned i = 0; i < 16; i++) {
        oracle_sample(16, i, &x, &y);
        columns |= 1u << (unsigned)(x * 16);
        rows |= 1u << (unsigned)(y * 16);
    }
    CHECK_EQ(columns, 0xffff);
    CHECK_EQ(rows, 0xffff);
}

/* Half of the samples show a floor that is twice as bright as white: each is clamped before the mean. */
TEST(samples_are_clamped_one_by_one)
{
    begin(TIA_AMBIENT_LIGHT);
    light.emission = (struct tia_rgb)TIA_RGB(1.5, 0.5, 0);
    scene.camera = (struct tia_camera){.eye = TIA_VEC3(0, 1, 0), .fov = TIA_Q16(60), .samples = 4};
    struct oracle_pixel p = oracle_pixel(&scene, 1, 1, 0, 0, false);

    NEAR(p.linear[0], 0.5);
    NEAR(p.linear[1], 0.25);
    CHECK_EQ(p.sphere, TIA_NO_OBJECT); /* the first sample's object */
}

int main(void)
{
    RUN(point_and_attenuation);
    RUN(directional);
    RUN(ambient_casts_no_shadow);
    RUN(spot);
    RUN(transmission);
    RUN(sample_pattern);
    RUN(area_samples);
    RUN(soft_shadow);
    RUN(lights_are_seen);
    RUN(lights_cast_no_shadow);
    RUN(checker);
    RUN(image);
    RUN(look_at);
    RUN(frustum);
    RUN(orthographic);
    RUN(samples);
    RUN(samples_are_clamped_one_by_one);
    return check_status();
}
