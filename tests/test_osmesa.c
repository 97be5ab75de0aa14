/* test_osmesa.c - the osmesa display: pixels drawn through GL are read back unchanged, with both libraries. */
#include <stdlib.h>

#include "check.h"

#ifndef TIA_HAVE_OSMESA
TEST(osmesa)
{
    SKIP("built without OSMesa and EGL (install libosmesa6-dev or libegl-dev)");
}
int main(void)
{
    RUN(osmesa);
    return check_status();
}
#else
#include "conform.h"
#include "osmesa/osmesa.h"

static const char *library; /* the library under test */
static char why[PORT_WHY];

static void *create(unsigned width, unsigned height)
{
    struct port_wish wish = {.device = library, .width = (uint16_t)width, .height = (uint16_t)height, .why = why};

    return port_osmesa_create(&wish);
}

/* Returns a display of this size, open; NULL after a failed check. */
static void *opened(unsigned width, unsigned height)
{
    void *ctx = create(width, height);

    if (!ctx || port_osmesa_display.open(ctx, &mode)) {
        CHECK_MSG(false, "%s", why);
        port_osmesa_destroy(ctx);
        return NULL;
    }
    CHECK_EQ(mode.width, width);
    CHECK_EQ(mode.height, height);
    return ctx;
}

static void closed(void *ctx)
{
    port_osmesa_display.close(ctx);
    port_osmesa_destroy(ctx);
}

/* Writes an image tile by tile and presents it. */
static void show(void *ctx, const tia_rgb565 *image, unsigned width, unsigned height, unsigned rows)
{
    for (unsigned top = 0; top < height; top += rows) {
        unsigned count = height - top < rows ? height - top : rows;
        struct tia_tile tile = {0, (uint16_t)top, (uint16_t)width, (uint16_t)count};
        struct tia_surface surface = {0};

        CHECK_EQ(port_osmesa_display.acquire(ctx, tile, &surface), TIA_OK);
        for (unsigned i = 0; i < count && surface.pixels; i++) {
            memcpy((char *)surface.pixels + (ptrdiff_t)i * surface.pitch, image + (size_t)(top + i) * width,
                   width * sizeof *image);
        }
        CHECK_EQ(port_osmesa_display.submit(ctx, tile), TIA_OK);
    }
    CHECK_MSG(!port_osmesa_display.present(ctx), "%s", why);
}

static void compare(void *ctx, const tia_rgb565 *image, unsigned width, unsigned height)
{
    const tia_rgb565 *shown = port_osmesa_read(ctx);

    CHECK(shown);
    for (size_t i = 0; shown && i < (size_t)width * height; i++) {
        CHECK_MSG(shown[i] == image[i], "%ux%u: pixel (%zu, %zu) is %04x, not %04x", width, height, i % width,
                  i / width, shown[i], image[i]);
    }
}

/* Returns an allocated pattern; 40503 is odd, so that all colours occur before one is repeated, and rows differ. */
static tia_rgb565 *pattern(unsigned width, unsigned height, unsigned seed)
{
    tia_rgb565 *image = malloc((size_t)width * height * sizeof *image);

    for (size_t i = 0; image && i < (size_t)width * height; i++)
        image[i] = (tia_rgb565)((i + seed) * 40503u);
    return image;
}

static void round_trip(unsigned width, unsigned height)
{
    tia_rgb565 *image = pattern(width, height, 1);
    void *ctx = opened(width, height);

    if (ctx) {
        show(ctx, image, width, height, 7);
        compare(ctx, image, width, height);
        closed(ctx);
    }
    free(image);
}

/* ---- the suite that every display passes, here with all pixels read back ---- */

static const tia_rgb565 *seen;

static void read_frame(void *arg, unsigned frames)
{
    (void)frames;
    seen = port_osmesa_read(arg);
    CHECK(seen);
}

static tia_rgb565 seen_pixel(void *arg, unsigned x, unsigned y)
{
    (void)arg;
    return seen ? seen[y * mode.width + x] : 0;
}

TEST(conformance)
{
    void *ctx = create(101, 67);

    CHECK_MSG(ctx, "%s", why);
    if (!ctx)
        return;
    subject = (struct subject){&port_osmesa_display, ctx, why, seen_pixel, read_frame, ctx, 0, 0};
    conform();
    port_osmesa_destroy(ctx);
}

/* ---- pictures in, pictures out ---- */

TEST(every_colour)
{
    round_trip(256, 256);
}

/* Sizes include rows of an odd number of pixels, single rows and single columns. */
TEST(any_size)
{
    static const unsigned sizes[][2] = {{1, 1}, {3, 5}, {1, 67}, {67, 1}, {641, 9}, {17, 481}, {8192, 2}, {2, 8192}};

    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++)
        round_trip(sizes[i][0], sizes[i][1]);
}

/* A frame is visible when it is presented, not before, and a second one replaces it. */
TEST(frame_after_frame)
{
    tia_rgb565 *first = pattern(65, 33, 1), *second = pattern(65, 33, 1000);
    void *ctx = opened(65, 33);
    struct tia_surface surface = {0};

    if (ctx) {
        show(ctx, first, 65, 33, 33);
        CHECK_EQ(port_osmesa_display.acquire(ctx, (struct tia_tile){0, 0, 1, 1}, &surface), TIA_OK);
        *surface.pixels = (tia_rgb565)~first[0];
        compare(ctx, first, 65, 33);
        show(ctx, second, 65, 33, 33);
        compare(ctx, second, 65, 33);
        closed(ctx);
    }
    free(first);
    free(second);
}

/* Each display has a context of its own: its picture does not depend on the other. */
TEST(two_displays)
{
    tia_rgb565 *left = pattern(40, 30, 5), *right = pattern(33, 31, 77);
    void *a = opened(40, 30), *b = opened(33, 31);

    if (a && b) {
        show(a, left, 40, 30, 30);
        show(b, right, 33, 31, 31);
        compare(a, left, 40, 30);
        compare(b, right, 33, 31);
        closed(a);
        compare(b, right, 33, 31);
        closed(b);
    }
    free(left);
    free(right);
}

/* Draws the built-in scene, lit by one of its keys, or unlit (key 0). */
static bool draw_frame(uint16_t key, tia_rgb565 *image, struct tia_tile all)
{
    const struct tia_core *core = &tia_core_q16;
    struct tia_scene scene = tia_thesis_scene;
    struct tia_surface surface = {.pixels = image, .step = 2, .pitch = 2 * (ptrdiff_t)all.width};
    struct tia_view *view;
    struct tia_hits *hits;
    size_t view_size, hits_size = core->hits_size(core, &scene, all);
    void *view_memory, *hits_memory = malloc(hits_size);
    bool drawn;

    for (uint32_t i = 0; i < scene.binding_count; i++) {
        if (scene.bindings[i].key == key) {
            scene.lights = &scene.bindings[i].state;
            scene.light_count = 1;
        }
    }
    view_size = core->view_size(core, &scene, scene.light_count);
    view_memory = malloc(view_size);
    drawn =
        !core->view_init(core, &view, view_memory, view_size, &scene, scene.light_count, all.width, all.height, NULL) &&
        !tia_hits_init(&hits, hits_memory, hits_size, view, all) && !tia_view_trace(view, hits, all) &&
        !tia_view_light(view, hits, all, &surface, NULL);
    free(view_memory);
    free(hits_memory);
    return drawn;
}

TEST(thesis_frames)
{
    static const uint16_t keys[] = {0, 'a', 'd', 's', 'w'};
    enum { WIDTH = 640, HEIGHT = 480 };
    static tia_rgb565 frames[2][WIDTH * HEIGHT];
    void *ctx = opened(WIDTH, HEIGHT);

    for (size_t i = 0; ctx && i < sizeof keys / sizeof keys[0]; i++) {
        tia_rgb565 *frame = frames[i % 2];
        CHECK(draw_frame(keys[i], frame, (struct tia_tile){0, 0, WIDTH, HEIGHT}));
        CHECK(memcmp(frames[0], frames[1], sizeof frames[0]) != 0);
        show(ctx, frame, WIDTH, HEIGHT, 100);
        compare(ctx, frame, WIDTH, HEIGHT);
    }
    if (ctx)
        closed(ctx);
}

TEST(open_again)
{
    tia_rgb565 *image = pattern(31, 17, 3);
    void *ctx = opened(31, 17);

    for (int i = 0; ctx && i < 5; i++) {
        show(ctx, image, 31, 17, 17);
        compare(ctx, image, 31, 17);
        port_osmesa_display.close(ctx);
        port_osmesa_display.close(ctx);
        CHECK_EQ(port_osmesa_display.present(ctx), TIA_ERR_ARGUMENT);
        CHECK_EQ(port_osmesa_display.open(ctx, &mode), TIA_OK);
    }
    if (ctx)
        closed(ctx);
    free(image);
}

/* Refusals have a reason in the form that every port uses, and closing is safe after them. */
TEST(refusals)
{
    struct port_wish other = {.device = "opengl", .why = why};
    struct tia_surface surface;
    void *ctx = create(65535, 1);

    CHECK_EQ(port_osmesa_display.open(ctx, &mode), TIA_ERR_UNSUPPORTED);
    CHECK_MSG(strstr(why, library) && strstr(why, "65535x1"), "%s", why);
    closed(ctx);
    CHECK(!port_osmesa_create(&other));
    CHECK_MSG(!strcmp(why, "osmesa:opengl: no such library in this build"), "%s", why);
    ctx = opened(4, 4);
    if (ctx) {
        CHECK_EQ(port_osmesa_display.open(ctx, &mode), TIA_ERR_ARGUMENT);
        CHECK_EQ(port_osmesa_display.acquire(ctx, (struct tia_tile){1, 0, 4, 4}, &surface), TIA_ERR_ARGUMENT);
        CHECK_EQ(port_osmesa_display.submit(ctx, (struct tia_tile){0, 4, 4, 1}), TIA_ERR_ARGUMENT);
        closed(ctx);
    }
}

static void count_line(void *arg, const char *text)
{
    CHECK_MSG(!strncmp(text, "osmesa:", 7) && strstr(text, "RGB565"), "%s", text);
    ++*(int *)arg;
}

TEST(listed)
{
    int lines = 0;

    port_osmesa_list(count_line, &lines);
    CHECK(lines > 0);
}

static void run_all(const char *name)
{
    static const struct {
        const char *name;
        void (*test)(void);
    } cases[] = {{"conformance", conformance},   {"every_colour", every_colour},
                 {"any_size", any_size},         {"frame_after_frame", frame_after_frame},
                 {"two_displays", two_displays}, {"thesis_frames", thesis_frames},
                 {"open_again", open_again},     {"refusals", refusals}};
    char title[64];

    library = name;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        (void)snprintf(title, sizeof title, "%s_%s", name, cases[i].name);
        check_run(title, cases[i].test);
    }
}

int main(void)
{
    /* keeps Mesa from storing compiled shaders in the user's home */
    (void)setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
#ifdef TIA_HAVE_LIBOSMESA
    run_all("osmesa");
#endif
#ifdef TIA_HAVE_EGL
    run_all("egl");
#endif
    RUN(listed);
    return check_status();
}
#endif
