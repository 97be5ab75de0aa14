/* tia_draw_rows: pictures row by row, against frames that tia_view_draw draws at once. */
#include <tia/tia.h>

#include "check.h"
#include "common/corpus/corpus.h"

enum { W = 61, H = 37, LIGHTS = 8 };

static uint64_t view_memory[20000], hits_memory[20000], rows_memory[30000];
static tia_rgb565 whole[W * H], sent[W * H];

/* What a panel receives. */
struct panel {
    unsigned rows, stop_after;
    int status; /* returned by the row that ends the picture */
    bool wrong; /* a row out of order, or of another width */
};

static int send(void *ctx, unsigned y, const tia_rgb565 *pixels, unsigned width)
{
    struct panel *panel = ctx;

    panel->wrong = panel->wrong || y != panel->rows || width != W || y >= H;
    if (panel->wrong)
        return TIA_ERR_DEVICE;
    memcpy(sent + y * W, pixels, sizeof *pixels * W);
    return ++panel->rows == panel->stop_after ? panel->status : TIA_OK;
}

static int draw_whole(const struct tia_rows *rows)
{
    const struct tia_tile frame = {0, 0, W, H};
    const struct tia_surface surface = {whole, sizeof *whole, sizeof *whole * W};
    const struct tia_options options = {.dither = rows->dither};
    struct tia_view *view;
    struct tia_hits *hits;
    int status =
        rows->core->view_init(rows->core, &view, view_memory, sizeof view_memory, rows->scene, LIGHTS, W, H, NULL);

    if (!status && rows->lights)
        status = tia_view_set_lights(view, rows->lights, rows->light_count);
    if (!status)
        status = tia_hits_init(&hits, hits_memory, sizeof hits_memory, view, frame);
    return status ? status : tia_view_draw(view, hits, frame, &surface, &options);
}

/* Draws both ways, in exactly the memory that is asked for. */
static void compare(const struct tia_rows *rows, const char *what)
{
    struct panel panel = {0};
    size_t size = tia_draw_rows_size(rows);

    CHECK(size <= sizeof rows_memory - 8);
    memset(rows_memory, 0xa5, sizeof rows_memory);
    memset(sent, 0x5a, sizeof sent);
    CHECK_MSG(draw_whole(rows) == TIA_OK, "%s: no frame", what);
    CHECK_MSG(tia_draw_rows(rows, rows_memory, size - 1, send, &panel) == TIA_ERR_MEMORY, "%s: too small", what);
    CHECK_MSG(panel.rows == 0, "%s: a row in too small a memory", what);
    CHECK_MSG(tia_draw_rows(rows, rows_memory, size, send, &panel) == TIA_OK, "%s: no rows", what);
    CHECK_MSG(panel.rows == H && !panel.wrong, "%s: %u rows", what, panel.rows);
    CHECK_MSG(!memcmp(sent, whole, sizeof sent), "%s: another picture, columns %u", what, rows->columns);
    for (const unsigned char *byte = (const unsigned char *)rows_memory + size, *end = byte + 8; byte < end; byte++)
        CHECK_MSG(*byte == 0xa5, "%s: a byte after the memory is written", what);
}

static struct tia_rows rows_of(const struct tia_core *core, const struct tia_scene *scene)
{
    return (struct tia_rows){.core = core, .scene = scene, .width = W, .height = H};
}

TEST(the_built_in_scene)
{
    const struct tia_core *const cores[] = {&tia_core_q16, &tia_core_spheres, &tia_core_spheres_small};
    const uint16_t columns[] = {0, 1, 7, 16, 60, UINT16_MAX};

    for (int i = 0; i < 3; i++)
        for (unsigned n = 0; n < sizeof columns / sizeof *columns; n++)
            for (uint32_t key = 0; key < tia_thesis_scene.binding_count; key++) {
                struct tia_rows rows = rows_of(cores[i], &tia_thesis_scene);
                rows.lights = &tia_thesis_scene.bindings[key].state;
                rows.light_count = 1;
                rows.columns = columns[n];
                rows.dither = n & 1;
                compare(&rows, cores[i]->name);
            }
}

TEST(lights)
{
    struct tia_light lights[LIGHTS];
    struct tia_rows rows = rows_of(&tia_core_spheres, &tia_thesis_scene);
    struct tia_scene scene = tia_thesis_scene;
    static tia_rgb565 own[W * H];

    for (uint32_t i = 0; i < tia_thesis_scene.binding_count; i++)
        lights[i] = tia_thesis_scene.bindings[i].state;
    compare(&rows, "none");
    scene.lights = lights;
    scene.light_count = 2;
    rows.scene = &scene;
    compare(&rows, "the scene's own");
    memcpy(own, sent, sizeof own);
    rows.lights = lights;
    compare(&rows, "none in place of the scene's");
    CHECK(memcmp(own, sent, sizeof own));
    rows.light_count = 4;
    compare(&rows, "more than the scene has");
    CHECK(memcmp(own, sent, sizeof own));
    rows.light_count = 2;
    compare(&rows, "the same");
    CHECK(!memcmp(own, sent, sizeof own));
}

TEST(random_scenes)
{
    static struct corpus_scene c;

    for (unsigned i = 0; i < check_count(40); i++) {
        corpus_random(&c, 27, i);
        struct tia_rows rows = rows_of(i & 1 ? &tia_core_q16 : &tia_core_spheres, &c.scene);
        rows.columns = i % 3 ? (uint16_t)(1 + i % W) : 0;
        compare(&rows, "a random scene");
    }
}

TEST(a_row_that_ends_the_picture)
{
    const int statuses[] = {TIA_STOPPED, TIA_ERR_DEVICE, 77};
    const struct tia_rows rows = rows_of(&tia_core_spheres, &tia_thesis_scene);

    for (int i = 0; i < 3; i++)
        for (unsigned n = 1; n <= H; n += H / 2) {
            struct panel panel = {.stop_after = n, .status = statuses[i]};
            CHECK_EQ(tia_draw_rows(&rows, rows_memory, sizeof rows_memory, send, &panel), statuses[i]);
            CHECK_EQ(panel.rows, n);
        }
}

TEST(a_scene_that_is_refused)
{
    const struct tia_sphere sphere = {{0, 0, TIA_Q16(-9)}, TIA_Q16(1), 0};
    const struct tia_scene scene = {
        .camera = {.fov = TIA_Q16(40)}, .spheres = &sphere, .sphere_count = 1, .material_count = 1};
    const struct tia_core *const cores[] = {&tia_core_q16, &tia_core_spheres, &tia_core_spheres_small};

    for (int i = 0; i < 3; i++) {
        const struct tia_rows rows = rows_of(cores[i], &scene);
        struct panel panel = {.stop_after = H};
        CHECK_EQ(tia_draw_rows(&rows, rows_memory, sizeof rows_memory, send, &panel), TIA_ERR_RANGE);
        CHECK_EQ(panel.rows, 0);
    }
}

TEST(fewer_columns_take_less_memory)
{
    struct tia_rows rows = rows_of(&tia_core_spheres, &tia_thesis_scene);
    size_t all = tia_draw_rows_size(&rows), before = 0;

    for (uint16_t columns = 1; columns <= W; columns++) {
        rows.columns = columns;
        CHECK(tia_draw_rows_size(&rows) >= before && tia_draw_rows_size(&rows) <= all);
        before = tia_draw_rows_size(&rows);
    }
    CHECK_EQ(before, all);
    rows.columns = UINT16_MAX;
    CHECK_EQ(tia_draw_rows_size(&rows), all);
}

int main(void)
{
    RUN(the_built_in_scene);
    RUN(lights);
    RUN(random_scenes);
    RUN(a_row_that_ends_the_picture);
    RUN(a_scene_that_is_refused);
    RUN(fewer_columns_take_less_memory);
    return check_status();
}
