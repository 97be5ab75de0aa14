/* Cancellation of drawing, in the middle of a picture that would take minutes, and of preparation. */
#include <stdlib.h>
#include <time.h>

#include <tia/motion.h>
#include <tia/render.h>

#include "check.h"

enum { W = 64, H = 48, MANY = 1000 };

static uint64_t view_memory[200000], hits_memory[W * H * 2 + 100];
static tia_rgb565 pixels[W * H];

/* ---- the callback ---- */

struct cancel {
    unsigned asked, until; /* asked: calls so far; until: number of the first call that returns true */
};

static bool ask(void *ctx)
{
    struct cancel *cancel = ctx;
    return ++cancel->asked >= cancel->until;
}

/* ---- pictures ---- */

static const struct tia_tile frame = {0, 0, W, H};

static struct tia_view *view_of(const struct tia_scene *scene, struct cancel *cancel)
{
    struct tia_view *view = NULL;

    CHECK_EQ(tia_view_init(&view, view_memory, sizeof view_memory, scene, scene->light_count, W, H,
                           &(struct tia_job){.stop = cancel ? ask : NULL, .ctx = cancel}),
             TIA_OK);
    return view;
}

static int draw(const struct tia_view *view, struct tia_hits **hits, int traced)
{
    const struct tia_surface surface = {.pixels = pixels, .step = 2, .pitch = 2 * W};
    int status = TIA_OK;

    if (!traced) {
        CHECK_EQ(tia_hits_init(hits, hits_memory, sizeof hits_memory, view, frame), TIA_OK);
        status = tia_view_trace(view, *hits, frame);
    }
    return status ? status : tia_view_light(view, *hits, frame, &surface, NULL);
}

static double cpu_seconds(void)
{
    return (double)clock() / CLOCKS_PER_SEC;
}

/* Arrays of the scene of scene_of: a ball on a ground, and MANY lights, of which `light_count` are used. */
static struct tia_sphere balls[2];
static struct tia_light lights[MANY];
static struct tia_material materials[1];

static struct tia_scene scene_of(uint32_t light_count)
{
    balls[0] = (struct tia_sphere){.centre = TIA_VEC3(0, -10004, -20), .radius = TIA_Q16(10000)};
    balls[1] = (struct tia_sphere){.centre = TIA_VEC3(0, 0, -20), .radius = TIA_Q16(4)};
    materials[0] = (struct tia_material){.colour = TIA_RGB(0.5, 0.5, 0.5)};
    for (int i = 0; i < MANY; i++)
        lights[i] = (struct tia_light){TIA_VEC3(i % 10 - 5, 20 + i / 10, -10), TIA_Q16(0.5), TIA_RGB(1, 1, 1)};
    struct tia_scene scene = tia_thesis_scene;
    scene.bindings = NULL;
    scene.binding_count = 0;
    scene.materials = materials;
    scene.material_count = 1;
    scene.spheres = balls;
    scene.sphere_count = 2;
    scene.lights = lights;
    scene.light_count = light_count;
    return scene;
}

/* Returns a scene that takes days for one pixel: each ray that meets the ball spawns two, to the depth 16, and each of
 * these needs 256 shadow rays to each of a thousand lights. */
static struct tia_scene endless_scene(void)
{
    struct tia_scene scene = scene_of(MANY);

    materials[0] = (struct tia_material){.colour = TIA_RGB(0.5, 0.5, 0.5),
                                         .mirror = TIA_RGB(1, 1, 1),
                                         .refraction = TIA_RGB(1, 1, 1),
                                         .index = TIA_Q16(1.5)};
    for (int i = 0; i < MANY; i++) {
        lights[i].kind = TIA_SPHERE_LIGHT;
        lights[i].samples = 256;
    }
    scene.depth = 16;
    return scene;
}

TEST(nobody_asks)
{
    struct tia_scene scene = scene_of(1);
    struct cancel never = {0, UINT32_MAX};
    struct tia_hits *hits = NULL;
    static tia_rgb565 plain[W * H];

    CHECK_EQ(draw(view_of(&scene, NULL), &hits, 0), TIA_OK);
    memcpy(plain, pixels, sizeof plain);
    CHECK_EQ(draw(view_of(&scene, &never), &hits, 0), TIA_OK);
    CHECK(!memcmp(plain, pixels, sizeof plain) && never.asked >= H);
}

/* Spans are cancelled at least row by row: after the stop no new row is begun, so that what is drawn are the first
 * rows. */
TEST(spans)
{
    struct tia_scene scene = scene_of(10);
    struct cancel cancel = {0, UINT32_MAX};
    struct tia_hits *hits = NULL;
    struct tia_view *view = view_of(&scene, &cancel);
    unsigned before = 0;

    CHECK_EQ(draw(view, &hits, 0), TIA_OK);
    for (unsigned until = 1; before < H - 1 && until < 100 * H; until++) {
        unsigned rows = 0, more = 0;
        memset(pixels, 0x5a, sizeof pixels);
        cancel = (struct cancel){0, until};
        CHECK_EQ(draw(view, &hits, 1), TIA_STOPPED);
        while (rows < H && pixels[rows * W] != 0x5a5a)
            rows++;
        for (unsigned y = rows; y < H; y++)
            more += pixels[y * W] != 0x5a5a;
        CHECK_MSG(more == 0 && rows < until + 1 && rows >= before, "%u rows by poll %u, %u before", rows, until,
                  before);
        before = rows;
    }
    CHECK_EQ(before, H - 1);
}

/* With many lights a row takes long, so it can be cancelled before its end. */
TEST(many_lights_in_a_row)
{
    struct tia_scene scene = scene_of(MANY);
    struct cancel cancel = {0, UINT32_MAX};
    struct tia_hits *hits = NULL;
    struct tia_view *view = view_of(&scene, &cancel);

    CHECK_EQ(draw(view, &hits, 0), TIA_OK);
    cancel.asked = 0;
    CHECK_EQ(draw(view, &hits, 1), TIA_OK);
    CHECK(cancel.asked > H + H / 4 * (MANY / 64));
}

TEST(a_trace_by_spans)
{
    struct tia_scene scene = scene_of(1);
    struct cancel cancel = {0, 1};
    struct tia_hits *hits = NULL;

    CHECK_EQ(draw(view_of(&scene, &cancel), &hits, 0), TIA_STOPPED);
    CHECK(cancel.asked <= 3);
}

/* Drawing by rays calls `stop` soon, and ends when it returns true. */
TEST(rays)
{
    struct tia_scene scene = endless_scene();
    struct tia_hits *hits = NULL;
    struct cancel cancel = {0, 1};
    struct tia_view *view = view_of(&scene, &cancel);
    double start = cpu_seconds();

    CHECK_EQ(tia_hits_init(&hits, hits_memory, sizeof hits_memory, view, frame), TIA_OK);
    CHECK_EQ(tia_view_trace(view, hits, frame), TIA_STOPPED);
    CHECK(cancel.asked <= 2);
    cancel.until = UINT32_MAX;
    CHECK_EQ(tia_view_trace(view, hits, frame), TIA_OK);
    for (unsigned until = 1; until < 100000; until = until * 10 + 3) {
        cancel = (struct cancel){0, until};
        CHECK_EQ(draw(view, &hits, 1), TIA_STOPPED);
        CHECK_MSG(cancel.asked <= until + 1, "asked %u times after the answer", cancel.asked - until);
    }
    CHECK(cpu_seconds() - start < 20);
}

/* A core calls `stop` through its table of functions, too. */
TEST(the_table_of_functions)
{
    struct tia_scene scene = endless_scene();
    struct cancel cancel = {0, 1};
    struct tia_view *view = NULL;
    struct tia_hits *hits = NULL;

    CHECK_EQ(tia_core_q16.view_init(&tia_core_q16, &view, view_memory, sizeof view_memory, &scene, scene.light_count, W,
                                    H, &(struct tia_job){.stop = ask, .ctx = &cancel}),
             TIA_OK);
    CHECK_EQ(tia_hits_init(&hits, hits_memory, sizeof hits_memory, view, frame), TIA_OK);
    CHECK_EQ(tia_view_trace(view, hits, frame), TIA_STOPPED);
}

/* ---- large scenes, before any pixel is drawn ---- */

enum { ITEMS = 10 * 4096, SHAPES = 0, SPHERES, FACES, NORMALS, CELLS, LIGHTS, KEYS, TRANSFORMS };

static struct {
    struct tia_material glass;
    struct tia_sphere spheres[ITEMS];
    struct tia_shape shapes[ITEMS];
    struct tia_transform transforms[ITEMS];
    struct tia_light lights[ITEMS];
    struct tia_vec3 corners[3];
    struct tia_face faces[ITEMS];
    struct tia_dir3 normals[ITEMS];
    uint8_t cells[ITEMS];
    struct tia_keyframe keys[ITEMS];
    struct tia_mesh mesh;
    struct tia_grid grid;
    struct tia_track track;
} many;

static void fill_many(void)
{
    many.glass = (struct tia_material){.refraction = TIA_RGB(1, 1, 1), .index = TIA_Q16(1.5)};
    for (int i = 0; i < 3; i++)
        many.corners[i] = (struct tia_vec3){i * TIA_Q16_ONE, i % 2 * TIA_Q16_ONE, 0};
    for (uint32_t i = 0; i < ITEMS; i++) {
        many.spheres[i] = (struct tia_sphere){TIA_VEC3(0, 0, -20), TIA_Q16_ONE, 0};
        many.shapes[i] = (struct tia_shape){.kind = TIA_SPHERE, .transform = 1, .sphere = {.radius = TIA_Q16_ONE}};
        many.transforms[i] = (struct tia_transform){.position = TIA_VEC3(0, 0, -9), .scale = TIA_VEC3(1, 1, 1)};
        many.lights[i] = (struct tia_light){TIA_VEC3(0, 9, -9), TIA_Q16(0.5), TIA_RGB(1, 1, 1)};
        for (uint32_t k = 0; k < 3; k++)
            many.faces[i].corner[k] = (struct tia_corner){k, TIA_NO_INDEX, TIA_NO_INDEX};
        many.normals[i] = (struct tia_dir3){TIA_Q30(1), 0, 0};
        many.keys[i] = (struct tia_keyframe){(tia_q16)i, TIA_VEC3(0, 0, -9)};
    }
    many.grid = (struct tia_grid){.size = {40, 32, 32}, .cell = TIA_Q16_ONE, .cells = many.cells};
    many.track = (struct tia_track){.target = TIA_MOVES_TRANSFORM, .keys = many.keys, .key_count = ITEMS};
}

/* Returns a scene with ITEMS objects of one kind. */
static struct tia_scene scene_of_many(int kind)
{
    struct tia_scene scene = {.camera = tia_thesis_scene.camera, .materials = &many.glass, .material_count = 1};

    many.mesh = (struct tia_mesh){.vertices = many.corners, .vertex_count = 3, .faces = many.faces, .face_count = 1};
    scene.shapes = many.shapes;
    scene.transforms = many.transforms;
    scene.transform_count = kind == TRANSFORMS ? ITEMS : 1;
    scene.shape_count = kind == SHAPES ? ITEMS : 1;
    scene.spheres = many.spheres;
    scene.sphere_count = kind == SPHERES ? ITEMS : 0;
    scene.lights = many.lights;
    scene.light_count = kind == LIGHTS ? ITEMS : 0;
    many.shapes[0] = (struct tia_shape){.kind = TIA_SPHERE, .transform = 1, .sphere = {.radius = TIA_Q16_ONE}};
    if (kind == FACES || kind == NORMALS) {
        many.mesh.face_count = kind == FACES ? ITEMS : 1;
        many.mesh.normals = many.normals;
        many.mesh.normal_count = kind == NORMALS ? ITEMS : 0;
        scene.meshes = &many.mesh;
        scene.mesh_count = 1;
        many.shapes[0] = (struct tia_shape){.kind = TIA_MESH, .transform = 1, .mesh = 0};
    }
    if (kind == CELLS) {
        scene.grids = &many.grid;
        scene.grid_count = 1;
    }
    if (kind == KEYS || kind == TRANSFORMS) {
        scene.tracks = &many.track;
        scene.track_count = 1;
    }
    return scene;
}

/* Checks that each of `passes` passes over the objects calls `stop` after every 4096 objects, and ends when it returns
 * true. */
static void check_preparing(int kind, unsigned passes)
{
    struct tia_scene scene = scene_of_many(kind);
    size_t size = tia_view_size(&scene, scene.light_count);
    struct cancel cancel = {0, UINT32_MAX};
    void *memory = malloc(size);
    struct tia_view *view = NULL;
    unsigned all;

    CHECK_EQ(tia_view_init(&view, memory, size, &scene, scene.light_count, W, H,
                           &(struct tia_job){.stop = ask, .ctx = &cancel}),
             TIA_OK);
    all = cancel.asked;
    CHECK_MSG(all >= 10 * passes - 1, "kind %d: %u questions in %u passes", kind, all, passes);
    for (unsigned until = 1; until <= all; until++) {
        cancel = (struct cancel){0, until};
        CHECK_EQ(tia_view_init(&view, memory, size, &scene, scene.light_count, W, H,
                               &(struct tia_job){.stop = ask, .ctx = &cancel}),
                 TIA_STOPPED);
        CHECK_MSG(cancel.asked <= until + 1, "kind %d: asked %u times after the answer", kind, cancel.asked - until);
    }
    free(memory);
}

TEST(preparing_a_view)
{
    fill_many();
    check_preparing(SHAPES, 2);  /* the check, and the shapes' constants */
    check_preparing(SPHERES, 1); /* the check */
    check_preparing(FACES, 4);   /* the check, the mesh's box, the box of the instance, the test for closed meshes */
    check_preparing(NORMALS, 1);
    check_preparing(CELLS, 1);
    check_preparing(LIGHTS, 3); /* the check of the scene, the check of new lights, the lights' constants */
    check_preparing(KEYS, 1);
    check_preparing(TRANSFORMS, 2); /* and the same number of keys */
}

TEST(a_scene_at_a_time)
{
    struct tia_scene scene, at;
    struct cancel cancel = {0, UINT32_MAX};
    size_t size;
    void *memory;

    fill_many();
    scene = scene_of_many(TRANSFORMS);
    size = tia_scene_at_size(&scene);
    memory = malloc(size);
    CHECK_EQ(tia_scene_at(&at, memory, size, &scene, 0, &(struct tia_job){.stop = ask, .ctx = &cancel}), TIA_OK);
    CHECK(cancel.asked >= 11); /* the transforms, then a track of many keys */
    for (unsigned until = cancel.asked; until > 0; until--) {
        cancel = (struct cancel){0, until};
        CHECK_EQ(tia_scene_at(&at, memory, size, &scene, 0, &(struct tia_job){.stop = ask, .ctx = &cancel}),
                 TIA_STOPPED);
        CHECK_EQ(cancel.asked, until);
    }
    free(memory);
}

/* Without a hierarchy, and for planes with one, a ray tests all objects; `stop` is called meanwhile. */
TEST(one_ray)
{
    struct tia_scene scene;
    struct cancel cancel = {0, UINT32_MAX};
    struct tia_view *view = NULL;
    struct tia_hits *hits = NULL;
    const struct tia_tile pixel = {0, 0, 1, 1};
    size_t size;
    void *memory;

    fill_many();
    scene = scene_of_many(SPHERES);
    size = tia_view_size(&scene, 0);
    memory = malloc(size);
    CHECK_EQ(tia_view_init(&view, memory, size, &scene, 0, W, H, &(struct tia_job){.stop = ask, .ctx = &cancel}),
             TIA_OK);
    CHECK_EQ(tia_hits_init(&hits, hits_memory, sizeof hits_memory, view, frame), TIA_OK);
    cancel.asked = 0;
    CHECK_EQ(tia_view_trace(view, hits, pixel), TIA_OK);
    CHECK(cancel.asked >= 10);
    cancel = (struct cancel){0, 1};
    CHECK_EQ(tia_view_trace(view, hits, pixel), TIA_STOPPED);
    CHECK(cancel.asked <= 3);
    free(memory);
}

int main(void)
{
    RUN(nobody_asks);
    RUN(spans);
    RUN(many_lights_in_a_row);
    RUN(a_trace_by_spans);
    RUN(rays);
    RUN(the_table_of_functions);
    RUN(preparing_a_view);
    RUN(a_scene_at_a_time);
    RUN(one_ray);
    return check_status();
}
