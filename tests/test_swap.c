/* test_swap.c - struct tia_surface's `swap`: with each renderer, plain and by vector units, a picture has the same
 * pixels with their bytes exchanged. */
#include <stdlib.h>

#include <tia/integrator.h>
#include <tia/simd.h>
#include <tia/tia.h>
#include <tia/trust.h>

#include "check.h"

#if TIA_SWAP
#include "common/corpus/corpus.h"
#include "reading.h"
#include "with_hierarchy.h"

enum { W = 67, H = 41, GAP = 5, LINE = 2 * W + GAP, SIZE = LINE * H };

static tia_rgb565 picture[2][SIZE]; /* without and with `swap` */

/* Ways to lay pixels out in memory: without gaps, every second one, and with rows from below. */
static struct tia_surface surface_of(int way, tia_rgb565 *pixels)
{
    const ptrdiff_t line = LINE * (ptrdiff_t)sizeof *pixels;

    switch (way) {
    case 0:
        return (struct tia_surface){.pixels = pixels, .step = 2, .pitch = line};
    case 1:
        return (struct tia_surface){.pixels = pixels, .step = 4, .pitch = line};
    default:
        return (struct tia_surface){.pixels = pixels + (SIZE - LINE), .step = 2, .pitch = -line};
    }
}

static void clear(void)
{
    for (int i = 0; i < SIZE; i++)
        picture[0][i] = picture[1][i] = 0x5a5a; /* what is not drawn is the same with its bytes exchanged */
}

/* Compares byte by byte. Returns the number of pixels that are not the same backwards, so that an exchange shows. */
static unsigned compare(const char *what, int way)
{
    const uint8_t *plain = (const uint8_t *)picture[0], *swapped = (const uint8_t *)picture[1];
    unsigned wrong = 0, uneven = 0;

    for (size_t i = 0; i < sizeof picture[0]; i++) {
        wrong += plain[i] != swapped[i ^ 1];
        uneven += plain[i] != plain[i ^ 1];
    }
    CHECK_MSG(!wrong, "%s, way %d: %u bytes", what, way, wrong);
    return uneven / 2;
}

/* Draws the frame, in tiles that begin at odd columns, too. */
static void draw(const struct tia_view *view, struct tia_hits *hits, int way, bool swap, bool dither)
{
    const struct tia_options options = {.dither = dither};
    const struct tia_surface all = surface_of(way, picture[swap]);

    for (unsigned x = 0, width = 33; x < W; x += width, width = W - 33) {
        const struct tia_tile tile = {(uint16_t)x, 0, (uint16_t)width, H};
        struct tia_surface surface = all;
        surface.swap = swap;
        surface.pixels = (tia_rgb565 *)(void *)((char *)all.pixels + (ptrdiff_t)x * all.step);
        CHECK_EQ(tia_view_draw(view, hits, tile, &surface, &options), TIA_OK);
    }
}

/* Draws a scene by plain C, or by vector units. Returns how many pixels show an exchange. */
static unsigned try(const struct tia_core *core, const struct tia_simd *simd, const struct tia_scene *scene,
                    const char *what)
{
    const struct tia_tile frame = {0, 0, W, H};
    size_t sizes[3] = {core->view_size(core, scene, scene->light_count), core->hits_size(core, scene, frame),
                       simd ? tia_simd_size(simd, scene, scene->light_count, 1) : 0};
    void *memory[3];
    struct tia_view *view;
    struct tia_hits *hits;
    unsigned uneven = 0;

    for (int i = 0; i < 3; i++)
        memory[i] = malloc(sizes[i] + 1);
    CHECK_EQ(core->view_init(core, &view, memory[0], sizes[0], scene, scene->light_count, W, H, NULL), TIA_OK);
    if (simd)
        CHECK_EQ(tia_view_set_simd(view, simd, memory[2], sizes[2]), TIA_OK);
    CHECK_EQ(tia_hits_init(&hits, memory[1], sizes[1], view, frame), TIA_OK);
    for (int way = 0; way < 6; way++) {
        clear();
        draw(view, hits, way / 2, false, way & 1);
        draw(view, hits, way / 2, true, way & 1);
        uneven += compare(what, way);
    }
    for (int i = 0; i < 3; i++)
        free(memory[i]);
    return uneven;
}

static void try_all(const struct tia_scene *scene, const char *what)
{
    const struct tia_simd *simd;

    CHECK_MSG(try(&tia_core_q16, NULL, scene, what) > 100, "%s: nothing would show", what);
    for (unsigned i = 0; (simd = tia_simd_at(i)) != NULL; i++)
        (void)try(&tia_core_q16, simd, scene, what);
}

static void try_hierarchy(const struct tia_scene *scene, unsigned boxes)
{
    (void)boxes;
    try_all(scene, "with a hierarchy");
}

TEST(spheres)
{
    static struct corpus_scene c;

    for (unsigned i = 0; i < check_count(8); i++) {
        corpus_random(&c, 5, i);
        try_all(&c.scene, "a random scene");
        (void)try(&tia_core_spheres_small, NULL, &c.scene, "a random scene, small");
    }
    for (const char *key = "adsw"; *key; key++) {
        CHECK_EQ(corpus_thesis(&c, (const char[]){*key, 0}, W, H), TIA_OK);
        try_all(&c.scene, "the built-in scene");
    }
    /* Pixels without light that are on a boundary between two levels are decided by themselves, in spans that two
     * lights reach. */
    memcpy(c.materials, c.scene.materials, c.scene.material_count * sizeof *c.materials);
    c.scene.materials = c.materials;
    for (uint32_t i = 0; i < c.scene.material_count; i++)
        c.materials[i].emission = (struct tia_rgb){1 << 29, 1 << 28, 1 << 29};
    c.lights[1] = c.lights[0];
    c.lights[1].centre.x += TIA_Q16(15);
    c.scene.light_count = 2;
    try_all(&c.scene, "emission of a half");
    /* A light in sight, by which rows are drawn in chunks. */
    c.scene.light_count = 1;
    c.lights[0].centre = (struct tia_vec3)TIA_VEC3(0, 0, -12);
    c.lights[0].radius = TIA_Q16(1);
    try_all(&c.scene, "a visible light");
}

static const char world[] = "camera eye 0 1 5 look 0 0.4 0 fov 50\n"
                            "background 0.3 0.5 0.9\n"
                            "light at 2 4 3 radius 0.5 emission 1 0.9 0.8\n"
                            "material clay colour 0.8 0.5 0.3\n"
                            "material glossy colour 0.2 0.3 0.5 mirror 0.4\n"
                            "plane point 0 -0.5 0 normal 0 1 0 material clay\n"
                            "box min -1 -0.5 -1 max 0 0.5 0 material clay\n"
                            "sphere centre 0.8 0.1 0.3 radius 0.6 material glossy\n";

TEST(rays_rasteriser_and_samples)
{
    static const char *const first[] = {"", "shadows zfail\n", "shadows map\n", "integrator ao\nspp 2\n",
                                        "integrator path\nspp 2\n"};
    static char text[sizeof world + 40];
    struct reading r;

    for (size_t i = 0; i < sizeof first / sizeof *first; i++) {
        (void)snprintf(text, sizeof text, "%s%s", first[i], world);
        read_string(&r, TIA_FORMAT_TIA, text);
        CHECK_MSG(r.status == TIA_OK, "%s is not read", first[i]);
        if (r.status == TIA_OK) {
            try_all(&r.scene, first[i]);
            with_hierarchy(&r.scene, try_hierarchy, 0);
        }
        read_end(&r);
    }
}

TEST(text)
{
    const struct tia_text text = {"Tia 27", 3, 2, 2, 0x1234, 0xfedc};
    const struct tia_tile frame = {0, 0, W, H};

    clear();
    for (int swap = 0; swap < 2; swap++) {
        struct tia_surface surface = surface_of(0, picture[swap]);
        surface.swap = swap;
        CHECK_EQ(tia_text_draw(&text, frame, &surface), TIA_OK);
    }
    CHECK(compare("text", 0) > 100);
}

static int keep_row(void *ctx, unsigned y, const tia_rgb565 *pixels, unsigned width)
{
    memcpy((tia_rgb565 *)ctx + (size_t)y * LINE, pixels, width * sizeof *pixels);
    return TIA_OK;
}

TEST(rows)
{
    static uint64_t memory[4000];
    static struct corpus_scene c;

    CHECK_EQ(corpus_thesis(&c, "a", W, H), TIA_OK);
    clear();
    for (int swap = 0; swap < 2; swap++) {
        const struct tia_rows rows = {
            .core = &tia_core_spheres, .scene = &c.scene, .width = W, .height = H, .columns = 15, .swap = swap};
        CHECK_EQ(tia_draw_rows(&rows, memory, sizeof memory, keep_row, picture[swap]), TIA_OK);
    }
    CHECK(compare("rows", 0) > 100);
}

/* Sums of a swapped picture are those of the picture. */
TEST(telltales)
{
    static uint64_t view_memory[4000], hits_memory[W * H + 64];
    static const uint32_t crc = 0; /* not compared here */
    static const struct tia_telltale telltale = {"part", {5, 3, 40, 30}, &crc};
    const struct tia_telltales all = {.telltales = &telltale, .telltale_count = 1, .width = W, .height = H};
    const struct tia_tile frame = {0, 0, W, H};
    struct tia_telltale_sum sums[2][3];
    static struct corpus_scene c;
    struct tia_view *view;
    struct tia_hits *hits;

    CHECK_EQ(corpus_thesis(&c, "a", W, H), TIA_OK);
    CHECK_EQ(tia_view_init(&view, view_memory, sizeof view_memory, &c.scene, c.scene.light_count, W, H, NULL), TIA_OK);
    CHECK_EQ(tia_hits_init(&hits, hits_memory, sizeof hits_memory, view, frame), TIA_OK);
    for (int way = 0; way < 3; way++)
        for (int swap = 0; swap < 2; swap++) {
            struct tia_surface surface = surface_of(way, picture[swap]);
            surface.swap = swap;
            CHECK_EQ(tia_view_draw(view, hits, frame, &surface, NULL), TIA_OK);
            CHECK_EQ(tia_telltales_add(&all, &sums[swap][way], frame, &surface), TIA_OK);
        }
    CHECK(sums[0][0].crc != 0 && !memcmp(sums[0], sums[1], sizeof *sums));
}

int main(void)
{
    RUN(spheres);
    RUN(rays_rasteriser_and_samples);
    RUN(text);
    RUN(rows);
    RUN(telltales);
    return check_status();
}

#else

TEST(swap)
{
    SKIP("surfaces have no swap (TIA_SWAP is 0)");
}

int main(void)
{
    RUN(swap);
    return check_status();
}

#endif
