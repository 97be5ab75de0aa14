/* tia_viewer_run with the key that changes the technique for shadows. */
#include <tia/motion.h>

#include "viewer/strips.h"
#include "viewer_world.h"

#define SMALL_WIDTH 32
#define SMALL_HEIGHT 24

/* A ground and a box on it. */
static const struct tia_shape shapes[] = {
    {.kind = TIA_PLANE, .material = 0, .plane = {TIA_VEC3(0, 0, 0), {0, TIA_Q30_ONE, 0}}},
    {.kind = TIA_BOX, .material = 0, .box = {TIA_VEC3(-1, 0, -1), TIA_VEC3(1, 2, 1)}},
};
static const struct tia_material material[] = {{.colour = TIA_RGB(0.5, 0.5, 0.5)}};
static const struct tia_light light[] = {
    {.centre = TIA_VEC3(3, 5, 2), .radius = TIA_Q16(1), .emission = TIA_RGB(1, 1, 1)}};
static struct tia_scene yard, variant;
static unsigned techniques; /* number of techniques */

static struct world *yard_world(void)
{
    struct world *w = world_new();

    yard = (struct tia_scene){.camera = {.eye = TIA_VEC3(0, 3, 9), .fov = TIA_Q16(45)},
                              .materials = material,
                              .shapes = shapes,
                              .lights = light,
                              .material_count = 1,
                              .shape_count = 2,
                              .light_count = 1,
                              .shadow_map = {.size = TIA_MAP_SIZE_MIN}};
    w->mode.width = SMALL_WIDTH;
    w->mode.height = SMALL_HEIGHT;
    w->viewer.scene = &yard;
    w->viewer.variant = &variant;
    return w;
}

/* Returns the scene with which the next frame is compared: each technique in turn, then the first one again. */
static const struct tia_scene *scene_of_frame(const struct world *w)
{
    static struct tia_scene now;

    now = yard;
    now.shadows = (enum tia_shadows)(w->frame_count % techniques);
    return &now;
}

TEST(one_technique_after_the_other)
{
    struct world *w = yard_world();

    w->scene_now = scene_of_frame;
    for (unsigned i = 0; i < techniques + 1; i++)
        world_event(w, START + 1000 * (i + 1), TIA_EVENT_TAP, 't');
    quit_at(w, START + 90000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frame_count, techniques + 2);
    for (unsigned i = 0; i < w->frame_count; i++) {
        CHECK_EQ(w->frames[i].told.shadows, i % techniques);
        CHECK_EQ(w->frames[i].told.relit, 0);
    }
    CHECK_EQ(yard.shadows, TIA_SHADOWS_TRACED);
}

/* Lights keep their places when the technique changes, and moved lights need no new hits. */
TEST(lights_between_techniques)
{
    struct world *w = yard_world();

    w->scene_now = NULL;
    world_event(w, START + 1000, TIA_EVENT_TAP, TIA_KEY_LEFT);
    world_event(w, START + 2000, TIA_EVENT_TAP, 't');
    world_event(w, START + 3000, TIA_EVENT_TAP, TIA_KEY_LEFT);
    quit_at(w, START + 90000);
    yard.shadows = TIA_SHADOWS_ZPASS; /* zfail is next, and draws the same */
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frame_count, 4);
    CHECK_EQ(w->frames[2].told.shadows, TIA_SHADOWS_ZFAIL);
    CHECK(w->frames[1].told.relit && !w->frames[2].told.relit && w->frames[3].told.relit);
    CHECK_EQ(w->frames[3].light.x, ONE);
}

/* Of 48 rows, tiles have 16, or 48 where exact maps set up a hundred faces for each of them: 48 pixels for each face.
 * Of two workers, each gets 24 rows at most, rounded up to 32. */
TEST(rows_of_tiles)
{
    static struct tia_face faces[100];
    static const struct tia_vec3 vertices[3] = {TIA_VEC3(0, 0, 0), TIA_VEC3(1, 0, 0), TIA_VEC3(0, 1, 0)};
    static const struct tia_mesh mesh = {.vertices = vertices, .vertex_count = 3, .faces = faces, .face_count = 100};
    static const struct tia_shape one = {.kind = TIA_MESH};
    static const uint32_t drawn_us[5] = {900, 900, 900, 300, 600}; /* 300 for each tile */

    for (int i = 0; i < 300; i++)
        faces[i / 3].corner[i % 3] = (struct tia_corner){(uint32_t)(i % 3), TIA_NO_INDEX, TIA_NO_INDEX};
    for (int i = 0; i < 5; i++) {
        struct world *w = yard_world();
        w->workers.count = i == 4 ? 2 : 0;
        w->viewer.job.workers = &w->workers;
        w->mode.width = WORLD_WIDTH;
        w->mode.height = WORLD_HEIGHT;
        w->viewer.pacing.frame_limit = 1;
        w->tile_us = 300;
        yard.meshes = &mesh;
        yard.mesh_count = 1;
        yard.shapes = i % 2 || i == 4 ? &one : shapes;
        yard.shape_count = i % 2 || i == 4 ? 1 : 2;
        yard.shadows = i / 2 ? TIA_SHADOWS_MAP_EXACT : TIA_SHADOWS_TRACED;
        CHECK_EQ(world_play(w), TIA_OK);
        CHECK_EQ(w->frames[0].told.draw_us, drawn_us[i]);
    }
}

/* Tiles behind the rasteriser: one at least for each worker, four where faces are few; all of about the same height. */
TEST(rows_of_tiles_by_faces)
{
    static const struct {
        enum tia_shadows shadows;
        uint32_t faces;
        unsigned width, height, workers, rows;
    } cases[] = {{TIA_SHADOWS_MAP_EXACT, 6, 640, 480, 1, 60},
                 {TIA_SHADOWS_MAP_EXACT, 6, 640, 480, 2, 60},
                 {TIA_SHADOWS_MAP_EXACT, 1000000, 640, 480, 1, 480},
                 {TIA_SHADOWS_MAP_EXACT, 1000000, 640, 480, 2, 240},
                 {TIA_SHADOWS_MAP_EXACT, 100, 1920, 1080, 1, 64},
                 {TIA_SHADOWS_MAP_EXACT, 5000, 1920, 1080, 1, 270},
                 {TIA_SHADOWS_MAP_EXACT, 5000, 1920, 1080, 2, 135},
                 {TIA_SHADOWS_MAP_EXACT, 1000000, 1920, 1080, 3, 360},
                 {TIA_SHADOWS_MAP_EXACT, 0, 1, 1, 1, 1},
                 {TIA_SHADOWS_MAP_EXACT, 0, 8192, 3, 8, 1},
                 {TIA_SHADOWS_MAP_EXACT, UINT32_MAX, 1, 7, 2, 4},
                 {TIA_SHADOWS_ZFAIL, 6, 640, 480, 1, 120},
                 {TIA_SHADOWS_ZFAIL, 6, 640, 480, 2, 60},
                 {TIA_SHADOWS_ZFAIL, 1000000, 640, 480, 1, 480},
                 {TIA_SHADOWS_MAP, 100, 1920, 1080, 1, 135},
                 {TIA_SHADOWS_RAYS, 5000, 1920, 1080, 2, 135},
                 {TIA_SHADOWS_ZPASS, 100000, 1920, 1080, 1, 180},
                 {TIA_SHADOWS_ZFAIL, 1000000, 1920, 1080, 3, 360},
                 {TIA_SHADOWS_ZFAIL, 0, 1, 1, 1, 1}};

    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        unsigned height = cases[i].height;
        const struct tia_mesh mesh = {.face_count = cases[i].faces};
        const struct tia_shape shape = {.kind = TIA_MESH};
        const struct tia_scene scene = {
            .meshes = &mesh, .mesh_count = 1, .shapes = &shape, .shape_count = 1, .shadows = cases[i].shadows};
        unsigned rows = tia_strips_raster_rows(&scene, cases[i].width, height, cases[i].workers);
        CHECK_MSG(rows == cases[i].rows, "%u rows in case %zu, not %u", rows, i, cases[i].rows);
        CHECK(rows > 0 && rows <= height && (height % rows == 0 || height % rows > rows / 2));
    }
}

/* Without memory for a variant of the scene, the key quits like others. A key that the scene binds has the scene's
 * effect. */
TEST(whose_key_it_is)
{
    struct world *w = yard_world();
    const struct tia_binding binding = {.key = 't', .light = 0, .state = {.centre = TIA_VEC3(-3, 5, 2), .radius = ONE}};

    w->viewer.variant = NULL;
    world_event(w, START + 500, TIA_EVENT_TAP, 't');
    world_event(w, START + 900, TIA_EVENT_TAP, TIA_KEY_LEFT);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK(w->next_event == 1 && w->frame_count == 1);
    w = yard_world();
    yard.bindings = &binding;
    yard.binding_count = 1;
    world_event(w, START + 500, TIA_EVENT_TAP, 't');
    quit_at(w, START + 90000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frame_count, 2);
    CHECK_EQ(w->frames[1].light.x, -3 * ONE);
    CHECK_EQ(w->frames[1].told.shadows, TIA_SHADOWS_TRACED);
}

/* A camera with a window of 2^-9 x 2^-9: objects more than 2^14 to its side are beyond the range of the rasteriser. */
static const struct tia_camera narrow = {
    .projection = TIA_FRUSTUM, .eye = TIA_VEC3(0, 3, 9), .window = {-64, 64, -64, 64, TIA_Q16(1)}};

/* If a box transmits light, only traced rays can draw it, and the key chooses these again. With a narrow window, far
 * corners are beyond the range of the rasteriser, which is detected only in preparation. */
TEST(what_only_rays_can_draw)
{
    static const struct tia_material clear = {.colour = TIA_RGB(0.5, 0.5, 0.5), .transmission = TIA_RGB(0.5, 0, 0)};
    static const struct tia_shape wide = {.kind = TIA_BOX, .box = {TIA_VEC3(-1, 0, -1), TIA_VEC3(20000, 2, 1)}};
    struct world *w = yard_world();

    yard.materials = &clear;
    world_event(w, START + 500, TIA_EVENT_TAP, 't');
    quit_at(w, START + 90000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frame_count, 2);
    CHECK_EQ(w->frames[1].told.shadows, TIA_SHADOWS_TRACED);
    w = yard_world();
    yard.shapes = &wide;
    yard.shape_count = 1;
    yard.camera = narrow;
    world_event(w, START + 500, TIA_EVENT_TAP, 't');
    quit_at(w, START + 90000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frame_count, 2);
    CHECK_EQ(w->frames[1].told.shadows, TIA_SHADOWS_TRACED);
}

/* When a light moves far away, vertices need other fraction bits, so the hits are traced again; then the light moves
 * back. */
TEST(a_light_moves_far_away)
{
    static const struct tia_shape floor[] = {
        {.kind = TIA_BOX, .box = {TIA_VEC3(-200, -1, -200), TIA_VEC3(200, 0, 200)}},
        {.kind = TIA_BOX, .box = {TIA_VEC3(-1, 0, -1), TIA_VEC3(1, 2, 1)}},
    };
    static const uint16_t keys[] = {TIA_KEY_RIGHT, TIA_KEY_PAGE_UP, TIA_KEY_LEFT, TIA_KEY_PAGE_DOWN};

    for (enum tia_shadows technique = TIA_SHADOWS_TRACED; technique <= TIA_SHADOWS_ZPASS_PLAIN; technique++) {
        struct world *w = yard_world();
        yard.shapes = floor;
        yard.shadows = technique;
        yard.scale_bits = 11;
        for (unsigned i = 0; i < 4; i++)
            world_event(w, START + 500 + 1000 * i, TIA_EVENT_TAP, keys[i]);
        quit_at(w, START + 90000);
        CHECK_EQ(world_play(w), TIA_OK);
        CHECK_EQ(w->frame_count, 5);
        CHECK_EQ(w->frames[2].light.x, TIA_Q16(2048 + 3));
        CHECK_EQ(w->frames[2].light.y, TIA_Q16(2048 + 5));
        CHECK(w->frames[1].told.relit && w->frames[4].told.relit);
    }
}

/* A key that would move a light out of the technique's range has no effect, and further keys continue from the old
 * place; traced rays have no such limit. Without memory for the old lights, the loop ends with an error. */
TEST(a_light_that_would_be_too_far_away_stays)
{
    struct world *w = yard_world();

    yard.camera = narrow;
    yard.shadows = TIA_SHADOWS_ZFAIL;
    yard.scale_bits = 13;
    for (unsigned i = 0; i < 4; i++)
        world_event(w, START + 500 + 1000 * i, TIA_EVENT_TAP, i == 3 ? TIA_KEY_PAGE_UP : TIA_KEY_RIGHT);
    quit_at(w, START + 90000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frames[1].light.x, TIA_Q16(8192 + 3));
    CHECK_EQ(w->frames[w->frame_count - 1].light.x, TIA_Q16(8192 + 3));
    CHECK_EQ(w->frames[w->frame_count - 1].light.y, TIA_Q16(8192 + 5));
    w = yard_world();
    yard.camera = narrow;
    yard.shadows = TIA_SHADOWS_TRACED;
    yard.scale_bits = 13;
    for (unsigned i = 0; i < 2; i++)
        world_event(w, START + 500 + 1000 * i, TIA_EVENT_TAP, TIA_KEY_RIGHT);
    world_event(w, START + 3000, TIA_EVENT_TAP, 't'); /* skips all techniques for which the light is too far away */
    quit_at(w, START + 90000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frame_count, 4);
    CHECK_EQ(w->frames[3].light.x, TIA_Q16(2 * 8192 + 3));
    CHECK_EQ(w->frames[3].told.shadows, TIA_SHADOWS_TRACED);
    w = yard_world();
    w->viewer.lights.kept = NULL;
    yard.camera = narrow;
    yard.shadows = TIA_SHADOWS_ZFAIL;
    yard.scale_bits = 13;
    for (unsigned i = 0; i < 2; i++)
        world_event(w, START + 500 + 1000 * i, TIA_EVENT_TAP, TIA_KEY_RIGHT);
    quit_at(w, START + 90000);
    CHECK_EQ(world_play(w), TIA_ERR_RANGE);
    CHECK_EQ(w->frame_count, 2);
}

/* A technique is skipped if the memory is too small for it: here six maps of 1024 x 1024. */
TEST(what_there_is_no_memory_for)
{
    struct world *w = yard_world();

    yard.shadow_map.size = 1024;
    for (unsigned i = 0; i < techniques; i++)
        world_event(w, START + 1000 * (i + 1), TIA_EVENT_TAP, 't');
    quit_at(w, START + 90000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frame_count, techniques + 1);
    for (unsigned i = 0; i < w->frame_count; i++)
        CHECK(w->frames[i].told.shadows != TIA_SHADOWS_MAP);
    CHECK_EQ(w->frames[techniques - 1].told.shadows, TIA_SHADOWS_TRACED);
}

/* Returns a world whose core has no draws_by_pixel, so that frames are drawn at once. The time of a tile passes when
 * the tile is requested from the display. */
static struct world *yard_at_once(void)
{
    static struct tia_core core;
    struct world *w = yard_world();

    core = tia_core_q16;
    core.draws_by_pixel = NULL;
    w->viewer.core = &core;
    return w;
}

/* The key ends a slow frame that is being drawn, as a key does that moves a light. */
TEST(in_the_middle_of_a_frame)
{
    struct world *w = yard_at_once();

    w->mode.tile_height = 4;
    w->tile_us = 100000;
    world_event(w, START + 50000, TIA_EVENT_TAP, 't');
    quit_at(w, START + 5000000);
    w->scene_now = NULL;
    yard.shadows = TIA_SHADOWS_ZPASS;
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frame_count, 1);
    CHECK_EQ(w->frames[0].told.shadows, TIA_SHADOWS_ZFAIL);
}

static unsigned drawn;

static void note_drawn(void *ctx, const struct tia_frame *frame)
{
    struct world *w = ctx;

    CHECK(w->tiles > 0 && !w->acquired); /* all tiles are drawn, but not yet shown */
    CHECK_EQ(frame->number, w->frame_count);
    CHECK_EQ(frame->draw_us, 300 * w->tiles);
    CHECK_EQ(frame->shadows, drawn++ % 2 ? TIA_SHADOWS_ZFAIL : TIA_SHADOWS_ZPASS);
}

TEST(told_before_it_is_shown)
{
    struct world *w = yard_at_once();

    drawn = 0;
    w->tile_us = 300;
    w->present_us = 7000;
    w->viewer.hooks.frame_drawn = note_drawn;
    yard.shadows = TIA_SHADOWS_ZPASS;
    world_event(w, START + 50000, TIA_EVENT_TAP, 't');
    quit_at(w, START + 90000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(drawn, 2);
}

/* Returns the scene at the time of the next frame: its eye moves, and changes of the technique do not stop the time. */
static const struct tia_scene *moving_scene(const struct world *w)
{
    static uint64_t memory[512];
    static struct tia_scene now;
    uint64_t drawn_us = w->frames[w->frame_count].drawn_us;

    CHECK_EQ(
        tia_scene_at(&now, memory, sizeof memory, &yard, (tia_q16)((drawn_us - START) * TIA_Q16_ONE / 1000000), NULL),
        TIA_OK);
    return &now;
}

TEST(while_it_plays)
{
    static const struct tia_keyframe keyframes[] = {{0, TIA_VEC3(0, 3, 9)}, {TIA_Q16(30), TIA_VEC3(3, 3, 9)}};
    static const struct tia_track tracks[] = {{.target = TIA_MOVES_EYE, .keys = keyframes, .key_count = 2}};
    struct world *w = yard_world();

    w->scene_now = moving_scene;
    yard.tracks = tracks;
    yard.track_count = 1;
    yard.shadows = TIA_SHADOWS_ZPASS;
    world_event(w, START + 100000, TIA_EVENT_TAP, 't');
    quit_at(w, START + 200000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK(w->frame_count >= 8);
    for (unsigned i = 0; i < w->frame_count; i++)
        CHECK_EQ(w->frames[i].told.shadows,
                 w->frames[i].drawn_us < START + 100000 ? TIA_SHADOWS_ZPASS : TIA_SHADOWS_ZFAIL);
}

int main(void)
{
    while (tia_shadows_name(techniques))
        techniques++;
    RUN(one_technique_after_the_other);
    RUN(lights_between_techniques);
    RUN(rows_of_tiles);
    RUN(rows_of_tiles_by_faces);
    RUN(whose_key_it_is);
    RUN(what_only_rays_can_draw);
    RUN(a_light_moves_far_away);
    RUN(a_light_that_would_be_too_far_away_stays);
    RUN(what_there_is_no_memory_for);
    RUN(in_the_middle_of_a_frame);
    RUN(told_before_it_is_shown);
    RUN(while_it_plays);
    return check_status();
}
