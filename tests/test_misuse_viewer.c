/* Misuse of the viewer, its ports and callbacks, and of the keys that move lights. */
#include "misuse_scene.h"

static struct tia_light lights[MISUSE_LIGHTS];
static bool detached[MISUSE_LIGHTS];
static struct tia_scene variant;
static struct tia_mode mode;

/* ---- correct ports ---- */

static int get_mode(void *ctx, struct tia_mode *out)
{
    (void)ctx;
    *out = mode;
    return TIA_OK;
}

static int acquire(void *ctx, struct tia_tile tile, struct tia_surface *surface)
{
    (void)ctx;
    *surface =
        (struct tia_surface){.pixels = misuse_pixels + tile.y * MISUSE_W + tile.x, .step = 2, .pitch = 2 * MISUSE_W};
    return TIA_OK;
}

static int acquire_nothing(void *ctx, struct tia_tile tile, struct tia_surface *surface)
{
    (void)ctx;
    (void)tile;
    *surface = (struct tia_surface){.pixels = NULL, .step = 2, .pitch = 2 * MISUSE_W};
    return TIA_OK;
}

static int submit(void *ctx, struct tia_tile tile)
{
    (void)ctx;
    (void)tile;
    return TIA_OK;
}

static int present(void *ctx)
{
    (void)ctx;
    return TIA_OK;
}

static int open_input(void *ctx)
{
    (void)ctx;
    return TIA_OK;
}

static void close_port(void *ctx)
{
    (void)ctx;
}

static int poll_input(void *ctx, struct tia_event *event)
{
    (void)ctx;
    (void)event;
    return 0;
}

static int wait_input(void *ctx, int timeout_ms)
{
    (void)ctx;
    (void)timeout_ms;
    return TIA_OK;
}

static void *memory(void *ctx, size_t size)
{
    (void)ctx;
    return size <= sizeof misuse_memory ? misuse_memory : NULL;
}

static void *misaligned(void *ctx, size_t size)
{
    return memory(ctx, size) ? MISALIGNED(misuse_memory) : NULL;
}

static void *no_memory(void *ctx, size_t size)
{
    (void)ctx;
    (void)size;
    return NULL;
}

static enum tia_effect weigh(void *ctx, const struct tia_event *event)
{
    (void)ctx;
    (void)event;
    return TIA_EFFECT_NONE;
}

static enum tia_effect act(void *ctx, const struct tia_event *event, struct tia_camera *camera)
{
    (void)camera;
    return weigh(ctx, event);
}

static const struct tia_display display = {get_mode, get_mode, acquire, submit, present, close_port};
static const struct tia_input input = {open_input, poll_input, wait_input, close_port};

/* Returns a viewer for one frame. */
static struct tia_viewer viewer(void)
{
    return (struct tia_viewer){.scene = &misuse_scene,
                               .lights = {.array = lights, .detached = detached, .capacity = MISUSE_LIGHTS},
                               .pacing = {.frame_limit = 1},
                               .ports = {.display = &display, .input = &input},
                               .hooks = {.memory = memory}};
}

static int run(struct tia_viewer v)
{
    return tia_viewer_run(&v);
}

#define WITH(field, value) (changed = viewer(), changed.field = (value), run(changed))

static int run_with_display(struct tia_display d)
{
    struct tia_viewer v = viewer();

    v.ports.display = &d;
    return run(v);
}

static int run_in_mode(uint16_t width, uint16_t height)
{
    mode.width = width;
    mode.height = height;
    return run(viewer());
}

static void prepare(void)
{
    misuse_read();
    misuse_scene.bvh = NULL;
    mode = (struct tia_mode){.width = MISUSE_W, .height = MISUSE_H, .format = "RGB565"};
    CHECK_EQ(run(viewer()), TIA_OK);
}

TEST(misuse_of_a_viewer)
{
    static struct tia_viewer_state on = {.goes_on = true, .light_count = MISUSE_LIGHTS + 1};
    struct tia_viewer changed;

    prepare();
    REFUSES(tia_viewer_run(NULL));
    REFUSES(run((struct tia_viewer){.scene = NULL}));
    REFUSES(run((struct tia_viewer){.scene = &misuse_scene}));
    REFUSES(WITH(scene, NULL));
    REFUSES(WITH(lights.array, NULL));
    REFUSES(WITH(lights.capacity, 1));
    REFUSES(WITH(key_count, 3)); /* the keys are NULL */
    REFUSES(WITH(pacing.time, -1));
    REFUSES(WITH(state, &on));
    REFUSES(WITH(hooks.memory, NULL));
    GIVES(TIA_ERR_MEMORY, WITH(hooks.memory, no_memory));
    GIVES(TIA_ERR_MEMORY, WITH(hooks.memory, misaligned));
    REFUSES(WITH(pacing.rate[0], 25));
    REFUSES(WITH(pacing.pace[0], 25));
    REFUSES((changed = viewer(), changed.pacing.rate[0] = 1000001, changed.pacing.rate[1] = 1, run(changed)));
    REFUSES((changed = viewer(), changed.pacing.rate[0] = 1, changed.pacing.rate[1] = UINT32_MAX, run(changed)));
    REFUSES((changed = viewer(), changed.pacing.pace[0] = UINT32_MAX, changed.pacing.pace[1] = 1, run(changed)));
    GIVES(TIA_OK, WITH(gaze, ((struct tia_gaze){1, 1, INT32_MIN, UINT32_MAX, UINT32_MAX, true})));
    GIVES(TIA_OK, WITH(simd, tia_simd_best()));
    misuse_end();
}

TEST(misuse_of_a_viewers_scene)
{
    static struct tia_scene bad;
    static const struct tia_keyframe key = {0, TIA_VEC3(1, 2, 3)};
    static const struct tia_track track = {.target = TIA_MOVES_LIGHT, .keys = &key, .key_count = 1};
    struct tia_viewer changed;

    prepare();
    bad = misuse_scene;
    bad.materials = NULL;
    GIVES(TIA_ERR_RANGE, WITH(scene, &bad));
    bad = misuse_scene;
    bad.shapes = NULL;
    GIVES(TIA_ERR_RANGE, WITH(scene, &bad));
    bad = misuse_scene;
    bad.shadows = (enum tia_shadows)77;
    GIVES(TIA_ERR_RANGE, WITH(scene, &bad));
    bad = misuse_scene;
    bad.tracks = &track;
    bad.track_count = 1;
    GIVES(TIA_OK, WITH(scene, &bad));
    REFUSES((changed = viewer(), changed.scene = &bad, changed.lights.detached = NULL, run(changed)));
    misuse_end();
}

TEST(misuse_of_a_display)
{
    struct tia_viewer changed;

    prepare();
    REFUSES(WITH(ports.display, NULL));
    REFUSES(run_with_display((struct tia_display){get_mode, NULL, acquire, submit, present, close_port}));
    REFUSES(run_with_display((struct tia_display){get_mode, get_mode, NULL, submit, present, close_port}));
    REFUSES(run_with_display((struct tia_display){get_mode, get_mode, acquire, NULL, present, close_port}));
    REFUSES(run_with_display((struct tia_display){get_mode, get_mode, acquire, submit, NULL, close_port}));
    REFUSES(run_with_display((struct tia_display){get_mode, get_mode, acquire_nothing, submit, present, close_port}));
    REFUSES(run_in_mode(0, MISUSE_H));
    REFUSES(run_in_mode(MISUSE_W, 0));
    REFUSES(run_in_mode(0, 0));
    REFUSES(run_in_mode(65535, 65535));
    REFUSES(run_in_mode(TIA_SIZE_MAX + 1, 1));
    misuse_end();
}

TEST(misuse_of_other_ports)
{
    static const struct tia_input no_poll = {open_input, NULL, wait_input, close_port},
                                  no_wait = {open_input, poll_input, NULL, close_port};
    static const struct tia_clock no_clock = {NULL};
    static const struct tia_workers no_workers = {.run = NULL};
    static const struct tia_control no_weigh = {NULL, act}, no_act = {weigh, NULL}, control = {weigh, act};
    struct tia_viewer changed;

    prepare();
    REFUSES(WITH(ports.input, &no_poll));
    REFUSES(WITH(ports.input, &no_wait));
    REFUSES((changed = viewer(), changed.ports.input = NULL, changed.pacing.frame_limit = 0, run(changed)));
    REFUSES(WITH(ports.clock, &no_clock));
    REFUSES(WITH(job.workers, &no_workers));
    REFUSES(WITH(hooks.control, &control)); /* the variant is NULL */
    REFUSES((changed = viewer(), changed.hooks.control = &no_weigh, changed.variant = &variant, run(changed)));
    REFUSES((changed = viewer(), changed.hooks.control = &no_act, changed.variant = &variant, run(changed)));
    GIVES(TIA_OK, (changed = viewer(), changed.hooks.control = &control, changed.variant = &variant, run(changed)));
    misuse_end();
}

/* ---- samples shown progressively ---- */

static uint64_t slow_clock(void *ctx)
{
    static uint64_t now;

    (void)ctx;
    return now += 20000;
}

enum { ENOUGH = 77 };

static int end_when_whole(void *ctx, const struct tia_frame *frame)
{
    (void)ctx;
    return frame->block == 1 ? ENOUGH : TIA_OK;
}

static int run_with_estimator(const struct tia_estimator *estimator)
{
    static const struct tia_clock clock = {slow_clock};
    struct tia_viewer v = viewer();

    v.estimator = estimator;
    v.ports.clock = &clock;
    v.pacing.frame_limit = 0;
    v.hooks.frame_done = end_when_whole;
    return run(v);
}

/* An estimator of a different arithmetic cannot read the core's views. */
TEST(misuse_of_an_estimator)
{
    static const struct tia_estimator other = {.name = "q16 or so"}, nameless = {.name = NULL};

    prepare();
    misuse_scene.integration.integrator = TIA_PATHS;
    misuse_scene.integration.spp = 4;
    GIVES(ENOUGH, run_with_estimator(&other));
    GIVES(ENOUGH, run_with_estimator(&nameless));
    GIVES(ENOUGH, run_with_estimator(&tia_estimator_q16));
    misuse_end();
}

static const struct tia_binding binding = {
    .key = 'a', .light = 7, .state = {.centre = TIA_VEC3(1, 2, 3), .emission = TIA_RGB(1, 1, 1)}};

TEST(misuse_of_keys)
{
    static struct tia_light dark[1] = {{.kind = TIA_DIRECTIONAL_LIGHT}}, odd[1] = {{.kind = (enum tia_light_kind)77}};
    struct tia_scene scene;
    uint32_t one = 1, five = 5, none = 0;

    prepare();
    scene = misuse_scene;
    scene.bindings = &binding;
    scene.binding_count = 1;
    REFUSES(tia_viewer_press(NULL, lights, &one, MISUSE_LIGHTS, 'a'));
    REFUSES(tia_viewer_press(&scene, NULL, &one, MISUSE_LIGHTS, 'a'));
    REFUSES(tia_viewer_press(&scene, lights, NULL, MISUSE_LIGHTS, 'a'));
    REFUSES(tia_viewer_press(&scene, lights, &five, 1, 'a'));
    REFUSES(tia_viewer_press(&scene, NULL, &one, 0, TIA_KEY_LEFT));
    GIVES(0, tia_viewer_press(&scene, NULL, &none, 0, 'a'));
    GIVES(0, tia_viewer_press(&scene, NULL, &none, 0, TIA_KEY_LEFT));
    GIVES(0, tia_viewer_press(&scene, dark, &one, 1, TIA_KEY_LEFT)); /* a dark light has no direction that could turn */
    GIVES(0, tia_viewer_press(&scene, odd, &one, 1, TIA_KEY_LEFT));
    GIVES(1, tia_viewer_press(&scene, lights, &one, MISUSE_LIGHTS, 'a'));
    GIVES(TIA_NO_LIGHT, tia_viewer_key_light(NULL, lights, 1, 'a'));
    GIVES(TIA_NO_LIGHT, tia_viewer_key_light(&scene, NULL, 1, TIA_KEY_LEFT));
    GIVES(0, tia_viewer_key_light(&scene, NULL, 0, 'a'));
    GIVES(5, tia_viewer_frame_time(5, 9, NULL));
    GIVES(INT32_MAX, tia_viewer_frame_time(0, 5, (const uint32_t[2]){0, 0}));
    GIVES(INT32_MAX, tia_viewer_frame_time(INT32_MAX, UINT32_MAX, (const uint32_t[2]){1, UINT32_MAX}));
    misuse_end();
}

int main(void)
{
    RUN(misuse_of_a_viewer);
    RUN(misuse_of_a_viewers_scene);
    RUN(misuse_of_a_display);
    RUN(misuse_of_other_ports);
    RUN(misuse_of_an_estimator);
    RUN(misuse_of_keys);
    return check_status();
}
