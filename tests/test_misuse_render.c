/* Misuse of views, lights, hits, tiles, surfaces and vector units. */
#include <limits.h>
#include <tia/debug.h>

#include "misuse_scene.h"

static struct tia_view *view;
static struct tia_hits *hits;

TEST(misuse_of_view_sizes)
{
    misuse_read();
    GIVES(SIZE_MAX, (intmax_t)tia_view_size(NULL, 1));
    GIVES(SIZE_MAX, (intmax_t)tia_hits_size(NULL, misuse_frame));
    GIVES(SIZE_MAX, (intmax_t)tia_simd_size(NULL, NULL, 1, 1));
    GIVES(SIZE_MAX, (intmax_t)tia_simd_size(tia_simd_best(), NULL, 1, 1));
    GIVES(0, tia_simd_size(NULL, &misuse_scene, 1, 1));
    GIVES(1, tia_view_size(&misuse_scene, UINT32_MAX) > UINT32_MAX);
    GIVES(1, tia_hits_size(&misuse_scene, TILE(0, 0, 65535, 65535)) > UINT32_MAX);
    GIVES(0, tia_draws_by_pixel(NULL));
    misuse_end();
}

TEST(misuse_of_view_init)
{
    misuse_read();
    size_t size = sizeof misuse_view_memory, need = tia_view_size(&misuse_scene, MISUSE_LIGHTS);
    void *memory = misuse_view_memory;

    REFUSES(misuse_init(NULL, memory, size, &misuse_scene, 8, 8));
    REFUSES(misuse_init(&view, NULL, size, &misuse_scene, 8, 8));
    REFUSES(misuse_init(&view, NULL, 0, &misuse_scene, 8, 8));
    REFUSES(misuse_init(&view, memory, size, NULL, 8, 8));
    REFUSES(misuse_init(&view, MISALIGNED(memory), size - 8, &misuse_scene, 8, 8));
    REFUSES(misuse_init(&view, (char *)memory + 2, size - 8, &misuse_scene, 8, 8));
    REFUSES(misuse_init(&view, memory, size, &misuse_scene, 0, 8));
    REFUSES(misuse_init(&view, memory, size, &misuse_scene, 8, 0));
    REFUSES(misuse_init(&view, memory, size, &misuse_scene, TIA_SIZE_MAX + 1, 8));
    REFUSES(misuse_init(&view, memory, size, &misuse_scene, 8, UINT_MAX));
    REFUSES(tia_view_init(&view, memory, size, &misuse_scene, 1, 8, 8, NULL));
    GIVES(TIA_ERR_MEMORY, misuse_init(&view, memory, need - 1, &misuse_scene, 8, 8));
    GIVES(TIA_ERR_MEMORY, misuse_init(&view, memory, 0, &misuse_scene, 8, 8));
    GIVES(TIA_ERR_MEMORY, tia_view_init(&view, memory, size, &misuse_scene, UINT32_MAX, 8, 8, NULL));
    GIVES(1, (misuse_init(&view, NULL, size, &misuse_scene, 8, 8), view == NULL));
    GIVES(TIA_OK, misuse_init(&view, memory, need, &misuse_scene, 8, 8));
    misuse_end();
}

static int init_with(struct tia_scene scene)
{
    return misuse_init(&view, misuse_view_memory, sizeof misuse_view_memory, &scene, 8, 8);
}

static struct tia_scene with_kind(int kind)
{
    static struct tia_shape shapes[2];
    struct tia_scene scene = misuse_scene;

    shapes[0] = shapes[1] = scene.shapes[0];
    shapes[0].kind = (enum tia_shape_kind)kind;
    scene.shapes = shapes;
    return scene;
}

#define CHANGED(field, value) (changed = misuse_scene, changed.field = (value), changed)

TEST(misuse_of_scenes)
{
    struct tia_scene changed;

    misuse_read();
    REFUSES(tia_scene_check(NULL, NULL));
    GIVES(TIA_ERR_RANGE, tia_scene_check(&(struct tia_scene){.depth = 99}, NULL));
    GIVES(TIA_ERR_RANGE, init_with(CHANGED(material_count, 0)));
    GIVES(TIA_ERR_RANGE, init_with(CHANGED(materials, NULL)));
    GIVES(TIA_ERR_RANGE, init_with(CHANGED(shapes, NULL)));
    GIVES(TIA_ERR_RANGE, init_with(CHANGED(lights, NULL)));
    GIVES(TIA_ERR_RANGE, init_with(CHANGED(shape_count, UINT32_MAX)));
    GIVES(TIA_ERR_RANGE, init_with(CHANGED(binding_count, 3)));
    GIVES(TIA_ERR_RANGE, init_with(CHANGED(depth, 1000000)));
    GIVES(TIA_ERR_RANGE, init_with(CHANGED(camera.samples, 7)));
    GIVES(TIA_ERR_RANGE, init_with(CHANGED(camera.projection, (enum tia_projection)77)));
    GIVES(TIA_ERR_RANGE, init_with(CHANGED(integration.integrator, (enum tia_integrator)77)));
    GIVES(TIA_ERR_RANGE, init_with(CHANGED(integration.tone, (enum tia_tone)77)));
    GIVES(TIA_ERR_RANGE, init_with(CHANGED(shadows, (enum tia_shadows)77)));
    GIVES(TIA_ERR_RANGE, init_with(with_kind(77)));
    GIVES(TIA_ERR_RANGE, init_with(with_kind(-1)));
    misuse_end();
}

TEST(misuse_of_lights)
{
    struct tia_light many[MISUSE_LIGHTS + 1], bad;

    misuse_prepare();
    for (int i = 0; i <= MISUSE_LIGHTS; i++)
        many[i] = misuse_scene.lights[0];
    memset(&bad, 0xff, sizeof bad);
    REFUSES(tia_view_set_lights(NULL, many, 1));
    GIVES(TIA_ERR_RANGE, tia_view_set_lights(misuse_view, NULL, 1));
    GIVES(TIA_ERR_RANGE, tia_view_set_lights(misuse_view, &bad, 1));
    GIVES(TIA_ERR_MEMORY, tia_view_set_lights(misuse_view, many, MISUSE_LIGHTS + 1));
    GIVES(TIA_OK, tia_view_set_lights(misuse_view, NULL, 0));
    GIVES(TIA_OK, tia_view_set_lights(misuse_view, many, MISUSE_LIGHTS));
    misuse_end();
}

TEST(misuse_of_hits)
{
    misuse_prepare();
    void *memory = misuse_memory;
    size_t size = sizeof misuse_memory, need = tia_hits_size(&misuse_scene, misuse_frame);

    REFUSES(tia_hits_init(NULL, memory, size, misuse_view, misuse_frame));
    REFUSES(tia_hits_init(&hits, NULL, size, misuse_view, misuse_frame));
    REFUSES(tia_hits_init(&hits, NULL, 0, misuse_view, misuse_frame));
    REFUSES(tia_hits_init(&hits, MISALIGNED(memory), size - 8, misuse_view, misuse_frame));
    REFUSES(tia_hits_init(&hits, memory, size, NULL, misuse_frame));
    REFUSES(tia_hits_init(&hits, memory, size, misuse_view, TILE(0, 0, 0, 5)));
    REFUSES(tia_hits_init(&hits, memory, size, misuse_view, TILE(0, 0, 5, 0)));
    GIVES(TIA_ERR_MEMORY, tia_hits_init(&hits, memory, need - 1, misuse_view, misuse_frame));
    GIVES(TIA_ERR_MEMORY, tia_hits_init(&hits, memory, size, misuse_view, TILE(65535, 65535, 65535, 65535)));
    GIVES(1, (tia_hits_init(&hits, NULL, size, misuse_view, misuse_frame), hits == NULL));
    GIVES(TIA_NO_OBJECT, tia_hits_object(NULL, 0, 0));
    GIVES(TIA_NO_OBJECT, tia_hits_object(misuse_hits, 5, 5)); /* nothing is traced */
    CHECK_EQ(tia_view_trace(misuse_view, misuse_hits, misuse_frame), TIA_OK);
    GIVES(TIA_NO_OBJECT, tia_hits_object(misuse_hits, MISUSE_W, 0));
    GIVES(TIA_NO_OBJECT, tia_hits_object(misuse_hits, 0, MISUSE_H));
    GIVES(TIA_NO_OBJECT, tia_hits_object(misuse_hits, UINT_MAX, UINT_MAX));
    GIVES(TIA_NO_OBJECT, tia_hits_object(misuse_hits, 65536 + MISUSE_W / 2, 65536 + MISUSE_H / 2));
    GIVES(0, tia_hits_object(misuse_hits, MISUSE_W / 2, MISUSE_H / 2));
    misuse_end();
}

TEST(misuse_of_tracing)
{
    static uint64_t other_memory[4000];
    struct tia_view *other;

    misuse_prepare();
    CHECK_EQ(misuse_init(&other, other_memory, sizeof other_memory, &misuse_scene, MISUSE_W, MISUSE_H), TIA_OK);
    CHECK_EQ(tia_hits_init(&hits, misuse_memory, sizeof misuse_memory, misuse_view, TILE(20, 10, 60, 60)), TIA_OK);
    REFUSES(tia_view_trace(NULL, misuse_hits, misuse_frame));
    REFUSES(tia_view_trace(misuse_view, NULL, misuse_frame));
    REFUSES(tia_view_trace(other, misuse_hits, misuse_frame));
    REFUSES(tia_view_trace(misuse_view, misuse_hits, TILE(0, 0, 0, 0)));
    REFUSES(tia_view_trace(misuse_view, misuse_hits, TILE(1, 0, MISUSE_W, MISUSE_H)));
    REFUSES(tia_view_trace(misuse_view, misuse_hits, TILE(0, 1, MISUSE_W, MISUSE_H)));
    REFUSES(tia_view_trace(misuse_view, misuse_hits, TILE(65530, 0, 10, 10)));
    REFUSES(tia_view_trace(misuse_view, misuse_hits, TILE(0, 65535, 1, 65535)));
    REFUSES(tia_view_trace(misuse_view, hits, TILE(20, 10, 60, 60))); /* inside the hits, but not inside the image */
    REFUSES(tia_view_trace(misuse_view, hits, TILE(19, 10, 2, 2)));
    GIVES(TIA_OK, tia_view_trace(misuse_view, hits, TILE(20, 10, 12, 14)));
    misuse_end();
}

static int light_with(struct tia_surface surface)
{
    return tia_view_light(misuse_view, misuse_hits, misuse_frame, &surface, NULL);
}

static int render_with(struct tia_surface surface)
{
    return tia_view_draw(misuse_view, misuse_hits, misuse_frame, &surface, NULL);
}

TEST(misuse_of_lighting)
{
    const struct tia_surface *to = &misuse_surface;

    misuse_prepare();
    REFUSES(tia_view_light(misuse_view, misuse_hits, misuse_frame, to, NULL)); /* nothing is traced */
    REFUSES(tia_view_trace(misuse_view, misuse_hits, TILE(MISUSE_W, 0, 1, 1)),
            tia_view_light(misuse_view, misuse_hits, misuse_frame, to, NULL));
    CHECK_EQ(tia_view_trace(misuse_view, misuse_hits, misuse_frame), TIA_OK);
    REFUSES(tia_view_light(NULL, misuse_hits, misuse_frame, to, NULL));
    REFUSES(tia_view_light(misuse_view, NULL, misuse_frame, to, NULL));
    REFUSES(tia_view_light(misuse_view, misuse_hits, misuse_frame, NULL, NULL));
    REFUSES(tia_view_light(misuse_view, misuse_hits, TILE(0, 0, 0, 1), to, NULL));
    REFUSES(tia_view_light(misuse_view, misuse_hits, TILE(1, 0, MISUSE_W, 1), to, NULL));
    REFUSES(light_with((struct tia_surface){.pixels = NULL, .step = 2, .pitch = 2 * MISUSE_W}));
    REFUSES(light_with((struct tia_surface){.pixels = MISALIGNED(misuse_memory), .step = 2, .pitch = 2 * MISUSE_W}));
    REFUSES(light_with((struct tia_surface){.pixels = (void *)misuse_memory, .step = 3, .pitch = 2 * MISUSE_W}));
    REFUSES(light_with((struct tia_surface){.pixels = (void *)misuse_memory, .step = 2, .pitch = 2 * MISUSE_W + 1}));
    GIVES(TIA_OK, light_with((struct tia_surface){.pixels = misuse_pixels, .step = 0, .pitch = 0})); /* all pixels at
                                                                                                        one address */
    GIVES(TIA_OK, light_with(misuse_surface));
    misuse_end();
}

TEST(misuse_of_rendering)
{
    const struct tia_surface *to = &misuse_surface;

    misuse_prepare();
    REFUSES(tia_view_draw(NULL, misuse_hits, misuse_frame, to, NULL));
    REFUSES(tia_view_draw(misuse_view, NULL, misuse_frame, to, NULL));
    REFUSES(tia_view_draw(misuse_view, misuse_hits, misuse_frame, NULL, NULL));
    REFUSES(tia_view_draw(misuse_view, misuse_hits, TILE(0, 0, 0, 0), to, NULL));
    REFUSES(tia_view_draw(misuse_view, misuse_hits, TILE(0, 0, 1, MISUSE_H + 1), to, NULL));
    REFUSES(render_with((struct tia_surface){.pixels = NULL, .step = 2, .pitch = 2 * MISUSE_W}));
    REFUSES(render_with((struct tia_surface){.pixels = (void *)misuse_memory, .step = 1, .pitch = 2 * MISUSE_W}));
    REFUSES(render_with((struct tia_surface){.pixels = MISALIGNED(misuse_memory), .step = 2, .pitch = 2 * MISUSE_W}));
    GIVES(TIA_OK, render_with(misuse_surface));
    GIVES(TIA_OK, tia_view_draw(misuse_view, misuse_hits, misuse_frame, to, NULL)
                      ? 1
                      : tia_view_light(misuse_view, misuse_hits, misuse_frame, to, NULL));
    misuse_end();
}

/* Hits of spans have a different format. */
TEST(misuse_of_hits_of_spans)
{
    static struct tia_view *spans;
    static uint64_t memory[4000];
    struct tia_tile tile = {0, 0, MISUSE_W, 8};

    misuse_prepare();
    CHECK_EQ(tia_view_init(&spans, memory, sizeof memory, &tia_thesis_scene, 1, MISUSE_W, MISUSE_H, NULL), TIA_OK);
    memset(misuse_memory, 0x5a, sizeof misuse_memory);
    CHECK_EQ(tia_hits_init(&hits, misuse_memory, sizeof misuse_memory, spans, misuse_frame), TIA_OK);
    REFUSES(tia_view_light(spans, hits, tile, &misuse_surface, NULL));
    REFUSES(tia_view_light(spans, misuse_hits, tile, &misuse_surface, NULL));
    REFUSES(tia_view_trace(spans, misuse_hits, tile));
    REFUSES(tia_view_draw(spans, misuse_hits, tile, &misuse_surface, NULL));
    GIVES(TIA_NO_OBJECT, tia_hits_object(hits, 4, 4));
    GIVES(TIA_OK, tia_view_draw(spans, hits, tile, &misuse_surface, NULL));
    misuse_end();
}

TEST(misuse_of_levels)
{
    const struct tia_simd *simd = tia_simd_best();
    size_t need = tia_simd_size(simd, &misuse_scene, MISUSE_LIGHTS, 1);

    misuse_prepare();
    REFUSES(tia_view_set_simd(NULL, simd, misuse_memory, sizeof misuse_memory));
    GIVES(0, strcmp(tia_view_simd(NULL), "plain"));
    GIVES(TIA_OK, tia_view_set_simd(misuse_view, NULL, NULL, 0));
    if (need) {
        REFUSES(tia_view_set_simd(misuse_view, simd, NULL, need));
        REFUSES(tia_view_set_simd(misuse_view, simd, MISALIGNED(misuse_memory), sizeof misuse_memory - 8));
        GIVES(TIA_ERR_MEMORY, tia_view_set_simd(misuse_view, simd, misuse_memory, need - 1));
        GIVES(1, tia_simd_size(simd, &misuse_scene, UINT32_MAX, 1) > UINT32_MAX);
        CHECK_EQ(tia_view_set_simd(misuse_view, simd, misuse_memory, sizeof misuse_memory), TIA_OK);
        REFUSES(tia_view_light(misuse_view, misuse_hits, misuse_frame, NULL, NULL));
        GIVES(TIA_NO_OBJECT, tia_hits_object(misuse_hits, MISUSE_W, 0));
        /* the hits lack the pixels that vector units have traced */
        REFUSES(tia_view_trace(misuse_view, misuse_hits, misuse_frame) || tia_view_set_simd(misuse_view, NULL, NULL, 0)
                    ? 1
                    : tia_view_light(misuse_view, misuse_hits, misuse_frame, &misuse_surface, NULL));
    }
    GIVES(0, tia_simd_at(UINT_MAX) != NULL);
    REFUSES(tia_simd_named(NULL, &simd));
    REFUSES(tia_simd_named("plain", NULL));
    GIVES(0, tia_simd_raster(NULL) != NULL);
    misuse_end();
}

static int take_row(void *ctx, unsigned y, const tia_rgb565 *pixels, unsigned width)
{
    (void)ctx;
    return y < MISUSE_H && width == MISUSE_W && pixels ? TIA_OK : TIA_ERR_DEVICE;
}

static int draw_rows(struct tia_rows rows)
{
    return tia_draw_rows(&rows, misuse_memory, sizeof misuse_memory, take_row, NULL);
}

#define REFUSES_ROWS(member, value)                                                                                    \
    do {                                                                                                               \
        struct tia_rows changed = rows;                                                                                \
        changed.member = (value);                                                                                      \
        GIVES(SIZE_MAX, (intmax_t)tia_draw_rows_size(&changed));                                                       \
        REFUSES(draw_rows(changed));                                                                                   \
    } while (0)

TEST(misuse_of_rows)
{
    struct tia_rows rows = {.core = &tia_core_q16, .scene = &misuse_scene, .width = MISUSE_W, .height = MISUSE_H};
    struct tia_light bad;
    void *memory = misuse_memory;

    misuse_read();
    size_t need = tia_draw_rows_size(&rows);
    GIVES(SIZE_MAX, (intmax_t)tia_draw_rows_size(NULL));
    REFUSES(tia_draw_rows(NULL, memory, need, take_row, NULL));
    REFUSES(tia_draw_rows(&rows, NULL, need, take_row, NULL));
    REFUSES(tia_draw_rows(&rows, NULL, 0, take_row, NULL));
    REFUSES(tia_draw_rows(&rows, MISALIGNED(memory), need, take_row, NULL));
    REFUSES(tia_draw_rows(&rows, memory, need, NULL, NULL));
    REFUSES_ROWS(core, NULL);
    REFUSES_ROWS(scene, NULL);
    REFUSES_ROWS(light_count, 1);
    REFUSES_ROWS(width, 0);
    REFUSES_ROWS(height, 0);
    REFUSES_ROWS(width, TIA_SIZE_MAX + 1);
    REFUSES_ROWS(height, UINT16_MAX);
    GIVES(TIA_ERR_MEMORY, tia_draw_rows(&rows, memory, need - 1, take_row, NULL));
    GIVES(TIA_ERR_MEMORY, tia_draw_rows(&rows, memory, 0, take_row, NULL));
    GIVES(TIA_OK, tia_draw_rows(&rows, memory, need, take_row, NULL));
    rows.core = &tia_core_spheres;
    GIVES(TIA_ERR_RANGE, draw_rows(rows));
    rows.core = &tia_core_q16;
    memset(&bad, 0xff, sizeof bad);
    rows.lights = &bad;
    GIVES(TIA_OK, draw_rows(rows));
    rows.light_count = 1;
    GIVES(TIA_ERR_RANGE, draw_rows(rows));
    rows.light_count = UINT32_MAX;
    GIVES(TIA_ERR_MEMORY, draw_rows(rows));
    misuse_end();
}

int main(void)
{
    RUN(misuse_of_view_sizes);
    RUN(misuse_of_view_init);
    RUN(misuse_of_scenes);
    RUN(misuse_of_lights);
    RUN(misuse_of_hits);
    RUN(misuse_of_tracing);
    RUN(misuse_of_lighting);
    RUN(misuse_of_rendering);
    RUN(misuse_of_hits_of_spans);
    RUN(misuse_of_levels);
    RUN(misuse_of_rows);
    return check_status();
}
