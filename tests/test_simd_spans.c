/* Every instruction set against the exact pixels of docs/definition.md, some of each picture, and against each other
 * byte by byte, as checkasm does for dav1d. The kernels of each are called directly, whichever set would be chosen for
 * the processor. Instruction sets that the processor lacks are named.
 *
 *     test_simd_spans           as many scenes as seconds allow
 *     test_simd_spans N         N edge scenes, N/100 of the corpus and N/50 crowds, see tests/slow/simd */
#include <tia/simd.h>

#include "common/corpus/corpus.h"
#include "common/thread_pool.h"
#include "crowd_scene.h"
#include "edge_scene.h"
#include "render/renderer.h"
#include "simd_exact.h"

static const struct tia_simd *simd;
static const char *simd_name;
static unsigned edge_scenes = 700, random_scenes = 6, crowds = 24;

#define PIXELS 700 /* pixels of a picture that are compared with exact ones */

/* The pictures of the first instruction set, as hashes, in the order of the tests. */
static uint32_t *hashes;
static size_t hash_count, hash_next;
static bool first_set;

static uint32_t hash_of(const struct simd_frames *f)
{
    uint32_t hash = 2166136261u;

    for (size_t i = 0; i < f->bytes; i++)
        hash = (hash ^ f->got[i]) * 16777619u;
    return hash;
}

/* True if the picture is that of the first instruction set. */
static bool is_same(const struct simd_frames *f)
{
    uint32_t hash = hash_of(f);

    if (!first_set)
        return hash_next < hash_count && hashes[hash_next++] == hash;
    if ((hash_count & (hash_count - 1)) == 0)
        hashes = realloc(hashes, (2 * hash_count + 1) * sizeof *hashes);
    hashes[hash_count++] = hash;
    return true;
}

/* Checks a picture: its guards, some pixels against exact ones, and all against the first instruction set's, by a
 * hash. */
static void check_picture(const char *what, unsigned number, struct simd_frames *f, bool trace, bool dither)
{
    unsigned where[2] = {0, 0}, step = f->area.width * (unsigned)f->area.height / PIXELS | 1;
    bool simd_draws = strcmp(tia_view_simd(f->simd), simd_name) == 0;

    CHECK_MSG(simd_exact_draw(f, trace, dither) == 0, "%s %s %u: guards", simd_name, what, number);
    unsigned differ = simd_draws ? simd_exact_differ(f, dither, number, step, where) : 0;
    CHECK_MSG(differ == 0, "%s %s %u, %ux%u%s: %u pixels, (%u, %u)", simd_name, what, number, f->area.width,
              f->area.height, trace ? "" : ", relit", differ, where[0], where[1]);
    CHECK_MSG(is_same(f), "%s %s %u: not the other instruction sets' picture", simd_name, what, number);
}

/* Checks a frame, then the same frame relit with its first light moved. */
static void compare(const char *what, unsigned number, const struct tia_scene *scene, unsigned width, unsigned height,
                    bool dither)
{
    struct simd_frames f;
    struct tia_light moved[8];

    if (!simd_frames_open(&f, simd, scene, width, height))
        return;
    check_picture(what, number, &f, true, dither);
    if (scene->light_count > 0 && scene->light_count <= 8) {
        memcpy(moved, scene->lights, scene->light_count * sizeof *moved);
        moved[0].centre.x += TIA_Q16(1.25);
        moved[0].centre.y -= TIA_Q16(0.75);
        int plain = tia_view_set_lights(f.plain, moved, scene->light_count);
        CHECK_EQ(tia_view_set_lights(f.simd, moved, scene->light_count), plain);
        if (!plain)
            check_picture(what, number, &f, false, dither);
    }
    simd_frames_close(&f);
}

static void thesis_at(unsigned width, unsigned height)
{
    static const char *const keys[] = {"", "a", "d", "s", "w"};
    struct corpus_scene s;

    for (unsigned k = 0; k < sizeof keys / sizeof *keys; k++) {
        CHECK_EQ(corpus_thesis(&s, keys[k], width, height), TIA_OK);
        compare("thesis", k, &s.scene, width, height, false);
        if (width < 700)
            compare("thesis dithered", k, &s.scene, width, height, true);
    }
}

TEST(thesis)
{
    static const uint16_t sizes[8][2] = {{320, 240}, {640, 480}, {1280, 720}, {1920, 1080},
                                         {321, 243}, {17, 100},  {8192, 5},   {1, 1}};

    for (int i = 0; i < 8; i++)
        thesis_at(sizes[i][0], sizes[i][1]);
}

/* A picture so large that rows are written past the caches; then a tile at odd positions. */
TEST(large_pictures)
{
    enum { W = 8192, H = 520, GAP = GUARD / 2 };
    const struct tia_tile odd = {1, 201, W - 4, 3};
    struct corpus_scene s;
    struct simd_frames f;

    CHECK_EQ(corpus_thesis(&s, "a", W, H), TIA_OK);
    compare("large", 0, &s.scene, W, H, false);
    CHECK(simd_frames_open(&f, simd, &s.scene, W, H));
    CHECK_EQ(simd_exact_draw(&f, true, false), 0);
    memset(f.want, GUARDED, f.bytes);
    struct tia_surface part = simd_frames_surface(f.want + (GAP + 2), f.pitch);
    CHECK_EQ(tia_view_draw(f.simd, f.hits[1], odd, &part, NULL), TIA_OK);
    for (unsigned y = 0; y < odd.height; y++)
        CHECK(memcmp((char *)part.pixels + (ptrdiff_t)y * f.pitch,
                     f.got + GUARD + (size_t)f.pitch * (odd.y + y) + odd.x * sizeof(tia_rgb565),
                     odd.width * sizeof(tia_rgb565)) == 0);
    simd_frames_close(&f);
}

TEST(random_corpus)
{
    static struct corpus_scene s;

    for (unsigned i = 0; i < random_scenes; i++) {
        corpus_random(&s, 7, i);
        compare("random", i, &s.scene, s.width, s.height, i % 7 == 6);
    }
}

TEST(edge_scenes_of_any_magnitude)
{
    static struct edge_scene e;

    for (unsigned i = 1; i <= edge_scenes; i++) {
        edge_make(&e, i);
        compare("edge", i, &e.scene, e.width, e.height, e.dither);
    }
}

/* Compares a scene byte by byte with plain C's picture; and, for the first instruction set, some pixels with the exact
 * ones. */
static void compare_crowd(unsigned number, const struct tia_scene *scene, unsigned width, unsigned height, bool dither)
{
    struct simd_frames f;
    unsigned where[2] = {0, 0}, step = width * height / 16 | 1;

    CHECK_MSG(simd_frames_open(&f, simd, scene, width, height), "crowd %u", number);
    CHECK(strcmp(tia_view_simd(f.simd), simd_name) == 0);
    CHECK_MSG(simd_frames_differ(&f, true, dither) == 0, "%s crowd %u: %s", simd_name, number, simd_frames_where(&f));
    unsigned differ = first_set ? simd_exact_differ(&f, dither, number, step, where) : 0;
    CHECK_MSG(differ == 0, "%s crowd %u: %u pixels, (%u, %u)", simd_name, number, differ, where[0], where[1]);
    simd_frames_close(&f);
}

TEST(crowds_of_spheres_and_lights)
{
    static struct crowd_scene c;

    for (unsigned i = 0; i < crowds; i++) {
        crowd_make(&c, i);
        compare_crowd(i, &c.scene, c.width, c.height, c.dither);
    }
}

/* Shadows of opaque balls in the coloured shadow of a large one. */
TEST(shadows_in_coloured_light)
{
    static struct crowd_scene c;

    crowd_make(&c, 1);
    c.materials[0] = (struct tia_material){.colour = {TIA_Q30(.9), TIA_Q30(.8), TIA_Q30(.7)}};
    c.materials[1] = c.materials[0];
    c.materials[1].transmission = (struct tia_rgb){TIA_Q30(.5), TIA_Q30(.8), TIA_Q30(.3)};
    c.spheres[0] = (struct tia_sphere){{0, TIA_Q16(-1003), TIA_Q16(-14)}, TIA_Q16(1000), 0};
    c.spheres[1] = (struct tia_sphere){{0, TIA_Q16(3), TIA_Q16(-14)}, TIA_Q16(2.5), 1};
    for (int i = 0; i < 6; i++)
        c.spheres[2 + i] = (struct tia_sphere){{TIA_Q16(i - 2.5), TIA_Q16(-1.5), TIA_Q16(-14 + i % 3)}, TIA_Q16(.3), 0};
    for (int i = 0; i < 10; i++)
        c.lights[i] = (struct tia_light){.centre = {TIA_Q16(.1 * i), TIA_Q16(12), TIA_Q16(-14 + .2 * i)},
                                         .emission = {TIA_Q30(.1), TIA_Q30(.1), TIA_Q30(.1)}};
    c.scene.sphere_count = 8;
    c.scene.light_count = 10;
    compare_crowd(0, &c.scene, 320, 240, false);
}

/* Tiles have odd sizes, and each is drawn through a surface that is rotated by a quarter, as the whole picture is. */
TEST(tiles_and_turned_surfaces)
{
    static const unsigned W = 200, H = 150, TILE = 37;
    static struct corpus_scene s;
    static tia_rgb565 want[200 * 150], got[200 * 150];
    struct simd_frames f;

    corpus_random(&s, 7, 3);
    CHECK(simd_frames_open(&f, simd, &s.scene, W, H));
    struct tia_surface turned = {.pixels = want, .step = 2 * H, .pitch = 2};
    CHECK_EQ(tia_view_draw(f.simd, f.hits[1], f.area, &turned, NULL), TIA_OK);
    for (unsigned y = 0; y < H; y += TILE)
        for (unsigned x = 0; x < W; x += TILE) {
            unsigned wide = W - x < TILE ? W - x : TILE, high = H - y < TILE ? H - y : TILE;
            struct tia_tile tile = {(uint16_t)x, (uint16_t)y, (uint16_t)wide, (uint16_t)high};
            struct tia_surface surface = {.pixels = got + x * H + y, .step = 2 * H, .pitch = 2};
            CHECK_EQ(tia_view_draw(f.simd, f.hits[1], tile, &surface, NULL), TIA_OK);
        }
    CHECK(memcmp(want, got, sizeof want) == 0);
    simd_frames_close(&f);
}

TEST(objects_and_path_hashes)
{
    enum { W = 320, H = 240 };
    static uint32_t want[W * H], got[W * H];
    static struct corpus_scene s;
    struct simd_frames f;

    for (unsigned i = 0; i < 8; i++) {
        corpus_random(&s, 7, i);
        CHECK(simd_frames_open(&f, simd, &s.scene, W, H));
        struct tia_options a = {.debug = &(struct tia_debug){.path_hash = want}},
                           b = {.debug = &(struct tia_debug){.path_hash = got}};
        struct tia_surface one = simd_frames_surface(f.want, f.pitch), other = simd_frames_surface(f.got, f.pitch);
        CHECK_EQ(tia_view_draw(f.plain, f.hits[0], f.area, &one, &a), TIA_OK);
        CHECK_EQ(tia_view_draw(f.simd, f.hits[1], f.area, &other, &b), TIA_OK);
        CHECK(memcmp(want, got, sizeof want) == 0);
        for (unsigned y = 0; y < H; y += 7)
            for (unsigned x = 0; x < W; x++)
                CHECK_EQ(tia_hits_object(f.hits[1], x, y), tia_hits_object(f.hits[0], x, y));
        simd_frames_close(&f);
    }
}

struct job {
    struct simd_frames *frames;
    unsigned rows;
};

static void draw_rows(void *arg, unsigned index)
{
    struct job *job = arg;
    struct simd_frames *f = job->frames;
    struct tia_tile tile = f->area;

    unsigned first = index * job->rows, left = f->area.height - first;
    tile.y = (uint16_t)first;
    tile.height = (uint16_t)(left < job->rows ? left : job->rows);
    struct tia_surface surface = simd_frames_surface(f->got + (size_t)f->pitch * tile.y, f->pitch);
    CHECK_EQ(tia_view_draw(f->simd, f->hits[1], tile, &surface, NULL), TIA_OK);
}

TEST(threads)
{
    struct threads *pool = threads_create(4);
    struct corpus_scene s;
    struct simd_frames f;

    CHECK_EQ(corpus_thesis(&s, "a", 640, 480), TIA_OK);
    CHECK(simd_frames_open(&f, simd, &s.scene, 640, 480));
    CHECK_EQ(simd_exact_draw(&f, true, false), 0);
    memcpy(f.want, f.got, f.bytes);
    memset(f.got, GUARDED, f.bytes);
    struct job job = {&f, 7};
    threads_run(pool, draw_rows, &job, (480 + job.rows - 1) / job.rows);
    CHECK(memcmp(f.want, f.got, f.bytes) == 0);
    simd_frames_close(&f);
    threads_destroy(pool);
}

/* Plain C draws with too little memory for SIMD kernels, and when the eye is in a sphere. */
TEST(plain_c_draws_the_rest)
{
    struct corpus_scene s;
    struct simd_frames f;

    CHECK_EQ(corpus_thesis(&s, "a", 64, 48), TIA_OK);
    CHECK(simd_frames_open(&f, simd, &s.scene, 64, 48));
    CHECK(strcmp(tia_view_simd(f.simd), simd_name) == 0 && strcmp(tia_view_simd(f.plain), "plain") == 0);
    CHECK_EQ(tia_view_set_simd(f.simd, simd, f.memory[2], tia_simd_size(simd, &s.scene, 1, 1) - 1), TIA_ERR_MEMORY);
    CHECK(strcmp(tia_view_simd(f.simd), "plain") == 0);
    simd_frames_close(&f);
    s.scene.camera.eye = tia_thesis_scene.spheres[1].centre;
    CHECK(simd_frames_open(&f, simd, &s.scene, 64, 48));
    CHECK(strcmp(tia_view_simd(f.simd), "plain") == 0);
    CHECK_EQ(simd_frames_differ(&f, true, false), 0);
    simd_frames_close(&f);
}

static void run_all(const struct tia_simd *tested, const char *name)
{
    char title[80];

    simd = tested;
    simd_name = name;
    first_set = hash_count == 0;
    hash_next = 0;
#define RUN_SIMD(test) ((void)snprintf(title, sizeof title, "%s: %s", name, #test), check_run(title, test))
    RUN_SIMD(thesis);
    RUN_SIMD(large_pictures);
    RUN_SIMD(random_corpus);
    RUN_SIMD(edge_scenes_of_any_magnitude);
    RUN_SIMD(crowds_of_spheres_and_lights);
    RUN_SIMD(shadows_in_coloured_light);
    RUN_SIMD(tiles_and_turned_surfaces);
    RUN_SIMD(objects_and_path_hashes);
    RUN_SIMD(threads);
    RUN_SIMD(plain_c_draws_the_rest);
}

TEST(names_of_levels)
{
    const struct tia_simd *found = tia_simd_best();

    CHECK_EQ(tia_simd_named("plain", &found), TIA_OK);
    CHECK(!found);
    CHECK_EQ(tia_simd_named("mmx", &found), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_simd_named("", &found), TIA_ERR_ARGUMENT);
    CHECK(tia_simd_size(NULL, &tia_thesis_scene, 1, 1) == 0);
}

int main(int argc, char **argv)
{
    static const char *const names[] = {"sse41", "avx2", "avx512", "neon", "rvv", "wasm"};

    if (argc > 1 && !check_is_word(argv[1])) {
        edge_scenes = (unsigned)check_number(argc, argv, 1, 0);
        random_scenes = edge_scenes / 100;
        crowds = edge_scenes / 50;
    }
    RUN(names_of_levels);
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        const struct tia_simd *found = NULL;
        for (unsigned k = 0; tia_simd_at(k); k++)
            found = strcmp(tia_simd_at(k)->name, names[i]) == 0 ? tia_simd_at(k) : found;
        if (found)
            run_all(found, names[i]);
        else
            printf("# %s: not on this processor, or not in this build\n", names[i]);
    }
    free(hashes);
    return check_status();
}
