/* A small scene for each shape, material, light and camera: f64 draws it like the oracle, q16 like f64.
 *
 * The scenes have objects on a floor; one object, the light or the camera is under test. */
#ifdef TIA_HAVE_F64
#include "against.h"
#include "check.h"
#include "common/corpus/corpus_rays.h"
#include "common/thread_pool.h"

#define WHITE TIA_RGB(1, 1, 1)
#define GREY TIA_RGB(0.5, 0.5, 0.5)
#define WIDTH 80
#define HEIGHT 60

enum { FLOOR, THING, BALL, BACK, MATERIALS };

static struct tia_material materials[MATERIALS];
static struct tia_sphere ball;
static struct tia_shape shapes[3];
static struct tia_transform transform;
static struct tia_texture texture;
static struct tia_light lights[2];
static struct tia_scene scene;
static struct corpus_rays parts; /* random parts, whose meshes and grid are used */
static struct threads *pool;

/* Begins a floor, a back wall, a ball and the object under test: a box at (0, 1, 0). */
static void begin(void)
{
    static const struct tia_material matt = {.colour = TIA_RGB(0.8, 0.6, 0.4), .exponent = TIA_Q16(1)};

    corpus_random_rays(&parts, 1, 3);
    for (int i = 0; i < MATERIALS; i++)
        materials[i] = matt;
    materials[FLOOR].colour = (struct tia_rgb)TIA_RGB(0.6, 0.7, 0.8);
    ball = (struct tia_sphere){TIA_VEC3(1.7, 0.7, 0.4), TIA_Q16(0.7), BALL};
    shapes[0] =
        (struct tia_shape){.kind = TIA_PLANE, .material = FLOOR, .plane = {TIA_VEC3(0, 0, 0), {0, TIA_Q30(1), 0}}};
    shapes[1] = (struct tia_shape){
        .kind = TIA_BOX, .material = THING, .box = {TIA_VEC3(-0.9, 0.1, -0.7), TIA_VEC3(0.8, 1.6, 0.9)}};
    shapes[2] = (struct tia_shape){
        .kind = TIA_PLANE, .material = BACK, .plane = {TIA_VEC3(0, 0, -4), {TIA_Q30(0.1), 0, TIA_Q30(1)}}};
    transform = (struct tia_transform){TIA_VEC3(0.1, 1, 0), TIA_VEC3(25, 40, -10), TIA_VEC3(1, 1, 1)};
    lights[0] = (struct tia_light){.centre = TIA_VEC3(3, 5, 4), .emission = WHITE};
    lights[1] = (struct tia_light){.kind = TIA_AMBIENT_LIGHT, .emission = TIA_RGB(0.1, 0.1, 0.2)};
    scene = (struct tia_scene){.camera = {.eye = TIA_VEC3(-0.3, 2.1, 7), .fov = TIA_Q16(42)},
                               .background = GREY,
                               .materials = materials,
                               .spheres = &ball,
                               .lights = lights,
                               .shapes = shapes,
                               .transforms = &transform,
                               .textures = &texture,
                               .meshes = parts.meshes,
                               .grids = &parts.grid};
    scene.material_count = MATERIALS;
    scene.sphere_count = scene.transform_count = scene.grid_count = 1;
    scene.light_count = scene.mesh_count = 2;
    scene.shape_count = 3;
    scene.camera.up = (struct tia_vec3)TIA_VEC3(0, 1, 0);
    scene.camera.reference = (struct tia_vec3)TIA_VEC3(0.2, 0.9, 0);
}

/* Draws the scene and compares. Rounding decides few pixels of scenes as plain as these: all but a few are the
 * oracle's, and none of q16 is more than a level off where it has f64's path. */
static void draw(const char *what)
{
    struct measure m = {.scene = &scene,
                        .width = WIDTH,
                        .height = HEIGHT,
                        .reference = &tia_core_f64,
                        .cores = {&tia_core_q16},
                        .core_count = 1,
                        .workers = threads_workers(pool)};
    struct tia_fault fault = {0};
    struct against a;
    struct tally t = {0};

    CHECK_MSG(!tia_scene_check(&scene, &fault), "%s: %s %u: %s: %s", what, fault.thing, fault.index, fault.field,
              fault.rule);
    CHECK_EQ(against_oracle(&tia_core_f64, &scene, WIDTH, HEIGHT, false, threads_workers(pool), &a), TIA_OK);
    against_list(what, &a);
    CHECK_MSG(a.tally.flips == a.undecided && a.tally.flips <= 2 && a.tally.stray == 0 && a.margin < 1e-6,
              "%s: f64: %ju flips, %ju undecided, %ju stray, margin %g", what, (uintmax_t)a.tally.flips,
              (uintmax_t)a.undecided, (uintmax_t)a.tally.stray, a.margin);
    CHECK_EQ(measure(&m, &t), TIA_OK);
    CHECK_MSG(t.astray <= 1 && t.flips <= 2 && t.one <= 2, "%s: q16: %ju flips, %ju one level, %ju at worst", what,
              (uintmax_t)t.flips, (uintmax_t)t.one, (uintmax_t)t.astray);
}

static void thing(enum tia_shape_kind kind, bool placed)
{
    begin();
    memset(&shapes[1], 0, sizeof shapes[1]);
    shapes[1].kind = kind;
    shapes[1].material = THING;
    shapes[1].transform = placed;
}

/* Draws the object unchanged, with a transform, and as glass on a mirroring floor, where rays start on its inside
 * too. */
static void draw_thing(const char *what)
{
    draw(what);
    if (shapes[1].kind != TIA_PLANE) {
        shapes[1].transform = 1;
        transform.scale = (struct tia_vec3)TIA_VEC3(0.8, 1.2, 0.9);
        draw(what);
    }
    materials[THING].refraction = (struct tia_rgb)WHITE;
    materials[THING].transmission = (struct tia_rgb)GREY;
    materials[THING].index = TIA_Q16(1.5);
    materials[THING].fresnel = true;
    materials[FLOOR].mirror = (struct tia_rgb)GREY;
    draw(what);
}

TEST(spheres)
{
    thing(TIA_SPHERE, false);
    shapes[1].sphere.centre = (struct tia_vec3)TIA_VEC3(-0.2, 0.8, 0.1);
    shapes[1].sphere.radius = TIA_Q16(0.9);
    draw_thing("sphere");
}

TEST(planes)
{
    thing(TIA_PLANE, false);
    shapes[1].plane = (struct tia_plane){TIA_VEC3(-1, 0, 0), {TIA_Q30(0.7), TIA_Q30(0.5), TIA_Q30(0.3)}};
    draw_thing("plane");
}

TEST(discs)
{
    thing(TIA_DISC, false);
    shapes[1].disc = (struct tia_disc){TIA_VEC3(0, 1, 0), {TIA_Q30(0.3), TIA_Q30(0.5), TIA_Q30(0.7)}, TIA_Q16(0.8)};
    draw_thing("disc");
}

TEST(cylinders)
{
    for (int capped = 0; capped < 2; capped++) {
        thing(TIA_CYLINDER, false);
        shapes[1].cylinder =
            (struct tia_cylinder){TIA_VEC3(-0.4, 0.3, 0), TIA_VEC3(0.3, 1.5, 0.5), TIA_Q16(0.6), capped};
        draw_thing(capped ? "cylinder" : "open cylinder");
    }
}

TEST(cones)
{
    for (int i = 0; i < 4; i++) {
        thing(TIA_CONE, false);
        shapes[1].cone = (struct tia_cone){TIA_VEC3(-0.2, 0.3, 0), TIA_VEC3(0.3, 1.7, 0.4), TIA_Q16(0.9),
                                           i / 2 ? TIA_Q16(0.3) : 0, i % 2};
        draw_thing(i % 2 ? "cone" : "open cone");
    }
}

TEST(boxes)
{
    begin();
    draw_thing("box");
}

TEST(triangles)
{
    thing(TIA_TRIANGLE, false);
    shapes[1].triangle =
        (struct tia_triangle){{TIA_VEC3(-0.8, 0.3, 0), TIA_VEC3(0.9, 0.2, 0.5), TIA_VEC3(-0.1, 1.6, -0.4)}};
    draw_thing("triangle");
}

TEST(meshes_and_grids)
{
    thing(TIA_MESH, true);
    shapes[1].mesh = 0;
    draw_thing("smooth ball");
    thing(TIA_MESH, true);
    shapes[1].mesh = 1;
    draw_thing("land");
    thing(TIA_GRID, true);
    draw_thing("grid");
}

/* Each part of a material is tested by itself, then all together. */
TEST(materials_one_by_one)
{
    struct tia_material *m = &materials[THING];

    begin();
    m->specular = (struct tia_rgb)GREY;
    m->exponent = TIA_Q16(40);
    materials[BALL].specular = (struct tia_rgb)WHITE;
    materials[BALL].exponent = TIA_Q16(2.5);
    draw("specular");
    m->emission = (struct tia_rgb)TIA_RGB(0.1, 0.3, 0);
    materials[BALL].facing = (struct tia_rgb)GREY;
    draw("emission and facing");
    m->transmission = (struct tia_rgb)TIA_RGB(0.8, 0.4, 0.2);
    materials[BALL].transmission = (struct tia_rgb)TIA_RGB(0.2, 0.4, 0.8);
    draw("transmission");
    materials[BALL].mirror = m->mirror = (struct tia_rgb)TIA_RGB(0.6, 0.7, 0.8);
    draw("mirror");
    materials[BALL].refraction = m->refraction = (struct tia_rgb)TIA_RGB(0.9, 0.8, 0.7);
    materials[BALL].index = TIA_Q16(1.33);
    m->index = TIA_Q16(2.4);
    draw("refraction");
    m->fresnel = true;
    draw("fresnel");
    materials[BALL].index = TIA_Q16(0.7);
    materials[BALL].fresnel = true;
    draw("an index below 1");
    scene.depth = 12;
    materials[FLOOR].mirror = materials[BACK].mirror = (struct tia_rgb)GREY;
    draw("depth");
}

TEST(textures)
{
    static const uint8_t texels[] = {255, 0, 0, 0, 200, 0, 10, 20, 240, 255, 255, 0, 128, 128, 128, 0, 99, 66};

    for (int i = 0; i < 4; i++) {
        begin();
        texture = (struct tia_texture){.kind = i < 2 ? TIA_CHECKER : TIA_IMAGE,
                                       .repeat = {TIA_Q16(2), TIA_Q16(1.25)},
                                       .offset = {i % 2 * TIA_Q16(0.3), i % 2 * TIA_Q16(-7.1)},
                                       .cells = {WHITE, TIA_RGB(0.2, 0.1, 0)},
                                       .bilinear = i == 3,
                                       .width = 3,
                                       .height = 2,
                                       .texels = texels};
        scene.texture_count = 1;
        materials[FLOOR].texture = materials[BALL].texture = 1;
        draw("texture on a plane and a ball");
        materials[THING].texture = 1;
        draw("texture on a box");
        shapes[1] = (struct tia_shape){.kind = TIA_CONE, .material = THING, .transform = 1};
        shapes[1].cone = (struct tia_cone){TIA_VEC3(0, -1, 0), TIA_VEC3(0.2, 0.8, 0), TIA_Q16(0.9), TIA_Q16(0.4), true};
        draw("texture on a cone");
        shapes[1] = (struct tia_shape){.kind = TIA_MESH, .material = THING, .transform = 1, .mesh = 1};
        draw("texture on a land");
        shapes[1].kind = TIA_GRID;
        shapes[1].grid = 0;
        draw("texture on a grid");
    }
}

static void light(enum tia_light_kind kind)
{
    begin();
    lights[0].kind = kind;
    lights[0].direction = (struct tia_dir3){TIA_Q30(-0.4), TIA_Q30(-0.7), TIA_Q30(-0.5)};
    lights[0].side[0] = (struct tia_vec3)TIA_VEC3(1, 0, -0.8);
    lights[0].side[1] = (struct tia_vec3)TIA_VEC3(0.3, 0.9, 0.2);
    lights[0].inner = TIA_Q16(12);
    lights[0].outer = TIA_Q16(24);
}

/* Each kind of light is tested, then with attenuation, then seen directly and in a mirror. */
TEST(lights_one_by_one)
{
#define NAME(KIND, name, what, traits) #name,
    static const char *const names[] = {TIA_LIGHTS(NAME)};
#undef NAME

    for (int kind = 0; kind < TIA_LIGHT_KINDS; kind++) {
        light((enum tia_light_kind)kind);
        draw(names[kind]);
        lights[0].constant = TIA_Q16(0.5);
        lights[0].linear = TIA_Q16(0.1);
        lights[0].quadratic = TIA_Q16(0.02);
        lights[0].samples = 7;
        if (kind != TIA_SPOT_LIGHT && kind != TIA_AMBIENT_LIGHT)
            lights[0].radius = TIA_Q16(0.6);
        materials[BACK].mirror = (struct tia_rgb)GREY;
        lights[0].centre = (struct tia_vec3)TIA_VEC3(1, 3, 0.5);
        draw(names[kind]);
    }
}

/* Attenuation of lights is in the file's units, and so are a floor's tiles. */
TEST(units)
{
    for (uint32_t bits = 0; bits <= TIA_SCALE_BITS_MAX; bits += 4) {
        begin();
        scene.scale_bits = (int32_t)bits;
        lights[0].constant = TIA_Q16(0.25);
        lights[0].linear = TIA_Q16(0.05);
        lights[0].quadratic = TIA_Q16(0.125);
        lights[0].emission = (struct tia_rgb)TIA_RGB(0.5, 0.5, 0.5);
        texture = (struct tia_texture){.kind = TIA_CHECKER,
                                       .repeat = {TIA_Q16(0.75) << (bits < 8 ? bits : 8), TIA_Q16(2)},
                                       .offset = {TIA_Q16(0.3), TIA_Q16(-7.1)},
                                       .cells = {WHITE, TIA_RGB(0.2, 0.1, 0)}};
        scene.texture_count = 1;
        materials[FLOOR].texture = 1;
        draw("units");
    }
}

/* Digits below those of Q16.16 are magnified by mirrors; they are large, so that a missing one would be detected. */
TEST(fine_digits)
{
    static const struct tia_fine_sphere spheres[1] = {{{25612, -32768, 32767}, -23041}};
    static const struct tia_fine_ends ends[3] = {{{0}},
                                                 {{32767, -25601, 23040}, {-32768, 20481, -17921}, 30720, -28159},
                                                 {{25344, 25345, 25346}, {25347, 25348, 25349}, 25350, 25351}};
    static const struct tia_fine fine = {{-30721, 28160, 32767}, {23041, -20480, 25601}, spheres, ends};

    for (int i = 0; i < 4; i++) {
        thing(i < 2 ? TIA_CYLINDER : TIA_CONE, i % 2);
        if (i < 2)
            shapes[1].cylinder =
                (struct tia_cylinder){TIA_VEC3(0.6, 0.3, 1), TIA_VEC3(0.3, 1.5, 1.5), TIA_Q16(0.02), false};
        else
            shapes[1].cone =
                (struct tia_cone){TIA_VEC3(0.6, 0.3, 1), TIA_VEC3(0.3, 1.5, 1.5), TIA_Q16(0.03), TIA_Q16(0.01), true};
        ball.radius = TIA_Q16(0.04);
        ball.centre = (struct tia_vec3)TIA_VEC3(0.55, 0.7, 1.3);
        scene.camera.eye = (struct tia_vec3)TIA_VEC3(0.5, 0.8, 1.9);
        scene.camera.reference = (struct tia_vec3)TIA_VEC3(0.5, 0.7, 1.3);
        materials[BALL].mirror = materials[THING].mirror = (struct tia_rgb)TIA_RGB(0.9, 0.9, 0.9);
        scene.fine = &fine;
        draw("fine digits");
    }
}

TEST(cameras)
{
    begin();
    scene.camera.up = (struct tia_vec3)TIA_VEC3(0.3, 1, -0.2);
    draw("look-at");
    scene.camera.up = (struct tia_vec3)TIA_VEC3(0, 0, 0);
    draw("along -z");
    scene.camera.window = (struct tia_window){TIA_Q16(-0.4), TIA_Q16(0.5), TIA_Q16(-0.5), TIA_Q16(0.2), TIA_Q16(1.1)};
    scene.camera.projection = TIA_FRUSTUM;
    draw("frustum");
    scene.camera.window = (struct tia_window){0, 0, TIA_Q16(-2), TIA_Q16(1.5), 0};
    scene.camera.projection = TIA_ORTHOGRAPHIC;
    draw("orthographic");
    scene.camera.samples = 4;
    draw("4 samples");
    scene.camera.samples = 16;
    scene.camera.projection = TIA_PERSPECTIVE;
    draw("16 samples");
}

int main(void)
{
    pool = threads_create(threads_processors());
    RUN(spheres);
    RUN(planes);
    RUN(discs);
    RUN(cylinders);
    RUN(cones);
    RUN(boxes);
    RUN(triangles);
    RUN(meshes_and_grids);
    RUN(materials_one_by_one);
    RUN_LONG(textures);
    RUN_LONG(lights_one_by_one);
    RUN(units);
    RUN(fine_digits);
    RUN(cameras);
    threads_destroy(pool);
    return check_status();
}
#else
#include "without_f64.h"
#endif
