/* Rendering: the pixels do not depend on tiles, hit buffers, surfaces or threads, and relighting gives
 * what a full render gives. */
#include <stdlib.h>

#include <tia/debug.h>
#include <tia/render.h>

#include "check.h"
#include "common/thread_pool.h"
#include "random.h"

enum { W = 97, H = 61, PIXELS = W * H, LIGHTS = 4, GUARD = 0xa5 };

#define RGB TIA_RGB

static const struct tia_material materials[] = {
    {RGB(0.6, 0.6, 0.6), RGB(0, 0, 0), RGB(0, 0, 0)},
    {RGB(1, 0.3, 0.2), RGB(0, 0, 0), RGB(0.05, 0, 0)},
    {RGB(0.2, 0.9, 0.4), RGB(0.7, 0.2, 0.5), RGB(0, 0, 0)},
};
static const struct tia_sphere spheres[] = {
    {TIA_VEC3(0, -1004, -20), TIA_Q16(1000), 0}, {TIA_VEC3(0, -1, -20), TIA_Q16(3), 1},
    {TIA_VEC3(3.5, 0.5, -17), TIA_Q16(1.5), 2},  {TIA_VEC3(-3, -2, -15), TIA_Q16(1.2), 2},
    {TIA_VEC3(-6, 2, -30), TIA_Q16(4), 1},
};
/* Lights: one is visible, before the ball; one lies behind it; one is out of sight. */
static const struct tia_light lights[] = {
    {TIA_VEC3(1, 1, -14), TIA_Q16(0.4), RGB(0.9, 0.5, 0.2)},
    {TIA_VEC3(4, 6, -26), TIA_Q16(2), RGB(0.4, 0.4, 1.2)},
    {TIA_VEC3(-20, 20, -8), 0, RGB(0.3, 0.6, 0.3)},
};
static const struct tia_scene scene = {
    .camera = {TIA_VEC3(0.25, 0.5, 1), TIA_Q16(30)},
    .background = RGB(0.2, 0.5, 0.8),
    .materials = materials,
    .spheres = spheres,
    .lights = lights,
    .material_count = 3,
    .sphere_count = 5,
    .light_count = 3,
};

static uint64_t view_memory[1000], hits_memory[PIXELS + 100];
static tia_rgb565 want[2][H][W]; /* expected pictures: plain, dithered */
static uint32_t want_reached[H][W];

static const struct tia_tile frame = {0, 0, W, H};

static struct tia_view *view_of(const struct tia_scene *s)
{
    struct tia_view *view = NULL;

    memset(view_memory, GUARD, sizeof view_memory);
    CHECK_EQ(tia_view_init(&view, view_memory, sizeof view_memory, s, LIGHTS, W, H, NULL), TIA_OK);
    return view;
}

static struct tia_hits *hits_of(const struct tia_view *view, struct tia_tile area)
{
    struct tia_hits *hits = NULL;

    CHECK_EQ(tia_hits_init(&hits, hits_memory, sizeof hits_memory, view, area), TIA_OK);
    return hits;
}

static void render_frame(const struct tia_view *view, tia_rgb565 out[H][W], bool dither, uint32_t *path_hash)
{
    struct tia_surface surface = {.pixels = out[0], .step = 2, .pitch = 2 * W};
    struct tia_options options = {.dither = dither, .debug = &(struct tia_debug){.path_hash = path_hash}};

    CHECK_EQ(tia_view_draw(view, hits_of(view, frame), frame, &surface, &options), TIA_OK);
}

static void render_wanted(void)
{
    const struct tia_view *view = view_of(&scene);

    render_frame(view, want[0], false, want_reached[0]);
    render_frame(view, want[1], true, NULL);
}

/* The picture has all features that the comparisons need. */
TEST(the_picture_has_everything)
{
    const struct tia_view *view = view_of(&scene);
    struct tia_hits *hits = hits_of(view, frame);
    unsigned seen[5] = {0}, background = 0, light = 0, tinted = 0, shadow = 0;

    CHECK_EQ(tia_view_trace(view, hits, frame), TIA_OK);
    for (unsigned y = 0; y < H; y++)
        for (unsigned x = 0; x < W; x++) {
            uint32_t object = tia_hits_object(hits, x, y), path_hash = want_reached[y][x];
            background += object == TIA_NO_OBJECT;
            seen[object == TIA_NO_OBJECT ? 0 : object]++;
            light += path_hash == UINT32_C(0xffff0000);
            tinted += path_hash >> 16 != 0 && path_hash >> 16 != 0xffff;
            shadow += object == 0 && (path_hash & 7) != 7;
        }
    CHECK(background > 100 && light > 10 && tinted > 10 && shadow > 10);
    for (int i = 0; i < 5; i++)
        CHECK(seen[i] > 20);
    CHECK(memcmp(want[0], want[1], sizeof want[0]));
}

/* ---- tiles ---- */

/* Areas of hits: the tile alone, the frame, or an area around the tile. */
enum area { AREA_TILE, AREA_FRAME, AREA_ODD };

static struct tia_tile area_around(struct tia_tile tile, enum area area)
{
    unsigned left = tile.x / 2, top = tile.y - tile.y / 3, right = ((unsigned)tile.x + tile.width + W) / 2;
    struct tia_tile odd = {(uint16_t)left, (uint16_t)top, (uint16_t)(right - left),
                           (uint16_t)(tile.y + tile.height - top)};

    return area == AREA_TILE ? tile : area == AREA_FRAME ? frame : odd;
}

static tia_rgb565 got[H][W];

static void render_tile(const struct tia_view *view, struct tia_tile tile, enum area area, bool dither)
{
    static uint32_t path_hash[PIXELS];
    struct tia_surface surface = {.pixels = &got[tile.y][tile.x], .step = 2, .pitch = 2 * W};
    struct tia_options options = {.dither = dither, .debug = &(struct tia_debug){.path_hash = path_hash}};

    CHECK_EQ(tia_view_draw(view, hits_of(view, area_around(tile, area)), tile, &surface, &options), TIA_OK);
    for (unsigned i = 0; i < (unsigned)tile.width * tile.height; i++)
        CHECK_EQ(path_hash[i], want_reached[tile.y + i / tile.width][tile.x + i % tile.width]);
}

static struct tia_tile tile_at(unsigned index, unsigned width, unsigned height)
{
    unsigned columns = (W + width - 1) / width, x = index % columns * width, y = index / columns * height;

    return (struct tia_tile){(uint16_t)x, (uint16_t)y, (uint16_t)(W - x < width ? W - x : width),
                             (uint16_t)(H - y < height ? H - y : height)};
}

/* Checks tiles forwards, backwards and shuffled: a step without a common factor with the count draws each tile once. */
static void check_tiles(unsigned width, unsigned height)
{
    const struct tia_view *view = view_of(&scene);
    unsigned count = ((W + width - 1) / width) * ((H + height - 1) / height);
    const unsigned steps[] = {1, count - 1, 7919};

    for (int order = 0; order < 3; order++)
        for (int area = AREA_TILE; area <= AREA_ODD; area++) {
            bool dither = (order + area) % 2;
            memset(got, GUARD, sizeof got);
            for (unsigned i = 0; i < count; i++)
                render_tile(view, tile_at((i + 1) * steps[order] % count, width, height), (enum area)area, dither);
            CHECK_MSG(!memcmp(got, want[dither], sizeof got), "tiles of %ux%u, order %d, hits %d", width, height, order,
                      area);
        }
}

TEST(every_tile_size_and_order)
{
    check_tiles(1, 1);
    check_tiles(1, H);
    check_tiles(W, 1);
    check_tiles(7, 3);
    check_tiles(64, 64);
    check_tiles(63, 2);
    check_tiles(W, H);
}

/* ---- surfaces ---- */

enum { ROOM = 2 * (W + 6) * (H + 6) };

/* Draws the frame in two tiles into a block of memory where pixel (x, y) is at `first` + x step + y pitch, and checks
 * all of the block. */
static void check_surface(ptrdiff_t first, ptrdiff_t step, ptrdiff_t pitch)
{
    static tia_rgb565 block[ROOM], expected[ROOM];
    const struct tia_view *view = view_of(&scene);
    const struct tia_tile tiles[] = {{0, 0, 70, H}, {70, 0, W - 70, H}};

    memset(block, GUARD, sizeof block);
    memset(expected, GUARD, sizeof expected);
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++)
            expected[first + (x * step + y * pitch) / 2] = want[0][y][x];
    for (int i = 0; i < 2; i++) {
        struct tia_surface surface = {.pixels = block + first + tiles[i].x * step / 2, .step = step, .pitch = pitch};
        CHECK_EQ(tia_view_draw(view, hits_of(view, tiles[i]), tiles[i], &surface, NULL), TIA_OK);
    }
    CHECK_MSG(!memcmp(block, expected, sizeof block), "step %td, pitch %td", step, pitch);
}

TEST(every_surface)
{
    const ptrdiff_t row = 2 * (W + 3), column = 2 * (H + 3), last_row = (H - 1) * (W + 3), last = W - 1;

    check_surface(0, 2, 2 * W);
    check_surface(9, 2, row);
    check_surface(9 + last_row, 2, -row);
    check_surface(9 + last, -2, row);
    check_surface(9 + last_row + last, -2, -row);
    check_surface(9, column, 2); /* rotated by a quarter, and mirrored */
    check_surface(9 + H - 1, column, -2);
    check_surface(9 + last * column / 2, -column, 2);
    check_surface(9 + last * column / 2 + H - 1, -column, -2);
    check_surface(0, 4, 4 * W); /* every second pixel of the memory */
}

/* ---- threads ---- */

struct job {
    const struct tia_view *view;
    struct tia_hits *hits;
};

static void draw_job(void *arg, unsigned index)
{
    const struct job *job = arg;
    struct tia_tile tile = tile_at(index, 9, 4);
    struct tia_surface surface = {.pixels = &got[tile.y][tile.x], .step = 2, .pitch = 2 * W};

    (void)tia_view_draw(job->view, job->hits, tile, &surface, NULL);
}

TEST(several_threads)
{
    struct threads *pool = threads_create(4);
    const struct tia_view *view = view_of(&scene);
    struct job job = {view, hits_of(view, frame)};

    for (int i = 0; i < 20; i++) {
        memset(got, GUARD, sizeof got);
        threads_run(pool, draw_job, &job, 11 * 16);
        CHECK(!memcmp(got, want[0], sizeof got));
    }
    threads_destroy(pool);
}

/* ---- relighting ---- */

static tia_q16 between(int low, int high)
{
    return (tia_q16)(low * TIA_Q16_ONE + (int64_t)(high - low) * (random_u32() >> 8) / 256);
}

/* Returns a light; many of them are visible, some inside a sphere or behind the eye. */
static struct tia_light random_light(bool grey)
{
    struct tia_light l = {{between(-8, 8), between(-6, 8), between(-40, 3)}, 0, {0, 0, 0}};

    l.radius = between(0, 4) < TIA_Q16_ONE ? 0 : between(0, 2) + TIA_RADIUS_MIN;
    l.emission.r = l.emission.g = l.emission.b = between(0, 1 << 14);
    if (!grey)
        l.emission.g = between(0, 1 << 14);
    return l;
}

/* Checks one view and its hits, lit again and again, in memory that was not zero. */
static void check_relighting(const struct tia_scene *s)
{
    static uint64_t kept_view[1000], kept_hits[PIXELS + 100];
    static tia_rgb565 relit[H][W], full[H][W];
    struct tia_surface surface = {.pixels = relit[0], .step = 2, .pitch = 2 * W};
    struct tia_light now[LIGHTS];
    struct tia_scene moved = *s;
    struct tia_view *view = NULL;
    struct tia_hits *hits = NULL;

    memset(kept_view, GUARD, sizeof kept_view);
    memset(kept_hits, GUARD, sizeof kept_hits);
    CHECK_EQ(tia_view_init(&view, kept_view, sizeof kept_view, s, LIGHTS, W, H, NULL), TIA_OK);
    CHECK_EQ(tia_hits_init(&hits, kept_hits, sizeof kept_hits, view, frame), TIA_OK);
    CHECK_EQ(tia_view_trace(view, hits, frame), TIA_OK);
    moved.lights = now;
    for (int i = 0; i < 250; i++) {
        struct tia_options options = {.dither = i % 3 == 0};
        moved.light_count = (uint32_t)i % (LIGHTS + 1);
        for (uint32_t n = 0; n < moved.light_count; n++)
            now[n] = random_light(i / 5 % 2);
        CHECK_EQ(tia_view_set_lights(view, now, moved.light_count), TIA_OK);
        CHECK_EQ(tia_view_light(view, hits, frame, &surface, &options), TIA_OK);
        render_frame(view_of(&moved), full, options.dither, NULL);
        CHECK_MSG(!memcmp(relit, full, sizeof full), "lights %d", i);
    }
}

TEST(relit_is_rendered)
{
    check_relighting(&scene);
}

/* Shadows are grey and, in every second case, so are the lights: red is then computed for all three channels. */
TEST(relit_in_grey_is_rendered)
{
    static const struct tia_material grey[] = {
        {RGB(0.6, 0.6, 0.6), RGB(0, 0, 0), RGB(0, 0, 0)},
        {RGB(0.9, 0.9, 0.9), RGB(0.25, 0.25, 0.25), RGB(0.1, 0.1, 0.1)},
        {RGB(0.2, 0.9, 0.4), RGB(0.5, 0.5, 0.5), RGB(0, 0, 0)},
    };
    struct tia_scene s = scene;

    s.materials = grey;
    check_relighting(&s);
}

int main(void)
{
    render_wanted();
    RUN(the_picture_has_everything);
    RUN(every_tile_size_and_order);
    RUN(every_surface);
    RUN(several_threads);
    RUN(relit_is_rendered);
    RUN(relit_in_grey_is_rendered);
    return check_status();
}
