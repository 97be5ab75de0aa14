/* test_compiled.c - scenes written by tia-compile draw the same bits as their files. */
#include <stdlib.h>

#include <tia/debug.h>
#include <tia/tia.h>

#include "check.h"
#include "common/scene/scene_load.h"

enum { WIDTH = 72, HEIGHT = 54 };

/* Scenes that the Makefile compiles: each scene of the gallery, and one of everything. */
extern const struct tia_scene compiled_every, compiled_glass, compiled_flake, compiled_chess, compiled_castle,
    compiled_avenue, compiled_vase, compiled_orrery, compiled_porch, compiled_shadow_volume, compiled_shadow_mapping,
    compiled_cornell, compiled_marbles, compiled_window, compiled_caustic, compiled_block, compiled_solids,
    compiled_desk, compiled_knots, compiled_fjord, compiled_dice, compiled_clockwork;

static uint32_t picture(const struct tia_scene *given)
{
    static tia_rgb565 pixels[WIDTH * HEIGHT];
    const struct tia_tile all = {0, 0, WIDTH, HEIGHT};
    struct tia_scene plain = *given, *scene = &plain;
    const struct tia_surface surface = {.pixels = pixels, .step = 2, .pitch = 2 * WIDTH};
    size_t view_size = tia_view_size(scene, scene->light_count), hits_size = tia_hits_size(scene, all);
    void *view_memory = malloc(view_size), *hits_memory = malloc(hits_size);
    struct tia_view *view;
    struct tia_hits *hits;

    plain.integration.spp = 1;
    plain.camera.samples = 1; /* one sample is enough to show a difference */
    CHECK_EQ(tia_view_init(&view, view_memory, view_size, scene, scene->light_count, WIDTH, HEIGHT, NULL), TIA_OK);
    CHECK_EQ(tia_hits_init(&hits, hits_memory, hits_size, view, all), TIA_OK);
    memset(pixels, 0, sizeof pixels);
    if (check_failed == 0)
        CHECK_EQ(tia_view_draw(view, hits, all, &surface, NULL), TIA_OK);
    free(view_memory);
    free(hits_memory);
    return tia_crc32(0, pixels, WIDTH * HEIGHT);
}

/* Returns the picture half a second after the beginning. */
static uint32_t moved(const struct tia_scene *scene)
{
    size_t size = tia_scene_at_size(scene);
    void *memory = malloc(size + 1);
    struct tia_scene at;
    uint32_t crc = 0;

    CHECK_EQ(tia_scene_at(&at, memory, size, scene, TIA_Q16(0.5), NULL), TIA_OK);
    if (check_failed == 0)
        crc = picture(&at);
    free(memory);
    return crc;
}

static void compare_keys(const struct tia_scene *compiled, const struct tia_scene *parsed)
{
    CHECK_EQ(compiled->binding_count, parsed->binding_count);
    for (uint32_t i = 0; i < parsed->binding_count && check_failed == 0; i++) {
        const struct tia_binding *got = &compiled->bindings[i], *want = &parsed->bindings[i];
        struct tia_scene with_got = *compiled, with_want = *parsed;
        with_got.lights = &got->state;
        with_want.lights = &want->state;
        with_got.light_count = with_want.light_count = 1;
        with_got.track_count = with_want.track_count = 0; /* tracks may be of other lights */
        CHECK_EQ(got->key, want->key);
        CHECK_EQ(got->light, want->light);
        CHECK_EQ(picture(&with_got), picture(&with_want));
    }
}

static void compare(const char *path, const struct tia_scene *compiled)
{
    static struct scene_file file;
    int status = scene_open(&file, path, TIA_FORMAT_TIA, true);

    CHECK_MSG(!status, "%.300s", file.why);
    if (status)
        return;
    CHECK_EQ(picture(compiled), picture(&file.scene));
    CHECK_EQ(compiled->track_count, file.scene.track_count);
    CHECK_EQ(tia_scene_duration(compiled), tia_scene_duration(&file.scene));
    if (file.scene.track_count > 0)
        CHECK_EQ(moved(compiled), moved(&file.scene));
    compare_keys(compiled, &file.scene);
    /* the hierarchy is compiled too, unless objects are few */
    CHECK(compiled->bvh || compiled->sphere_count + compiled->shape_count <= 4);
    scene_close(&file);
}

#define SAME_AS_ITS_FILE(scene)                                                                                        \
    TEST(scene)                                                                                                        \
    {                                                                                                                  \
        compare("scenes/" #scene ".tia", &compiled_##scene);                                                           \
    }

SAME_AS_ITS_FILE(glass)
SAME_AS_ITS_FILE(flake)
SAME_AS_ITS_FILE(chess)
SAME_AS_ITS_FILE(castle)
SAME_AS_ITS_FILE(avenue)
SAME_AS_ITS_FILE(desk)
SAME_AS_ITS_FILE(knots)
SAME_AS_ITS_FILE(fjord)
SAME_AS_ITS_FILE(dice)
SAME_AS_ITS_FILE(clockwork)
SAME_AS_ITS_FILE(vase)
SAME_AS_ITS_FILE(orrery)
SAME_AS_ITS_FILE(window)
SAME_AS_ITS_FILE(block)
SAME_AS_ITS_FILE(caustic)
SAME_AS_ITS_FILE(solids)

TEST(every)
{
    compare("tests/scenes/every.tia", &compiled_every);
}

TEST(porch)
{
    compare("scenes/porch.tia", &compiled_porch);
    CHECK_EQ(compiled_porch.shadows, TIA_SHADOWS_ZPASS);
}

TEST(marbles)
{
    compare("scenes/marbles.tia", &compiled_marbles);
    CHECK_EQ(compiled_marbles.falling->count, 8);
    CHECK_EQ(compiled_marbles.falling->end, 9 * TIA_Q16_ONE);
}

TEST(cornell)
{
    compare("scenes/cornell.tia", &compiled_cornell);
    CHECK_EQ(compiled_cornell.integration.integrator, TIA_PATHS);
    CHECK_EQ(compiled_cornell.integration.spp, 64);
    CHECK_EQ(compiled_cornell.lights[0].emission_bits, 4);
}

TEST(shadow_volume)
{
    compare("scenes/shadow-volume.tia", &compiled_shadow_volume);
    CHECK_EQ(compiled_shadow_volume.shadows, TIA_SHADOWS_ZFAIL);
}

TEST(shadow_mapping)
{
    compare("scenes/shadow-mapping.tia", &compiled_shadow_mapping);
}

int main(void)
{
    RUN(every);
    RUN(glass);
    RUN(flake);
    RUN(chess);
    RUN(castle);
    RUN(avenue);
    RUN(desk);
    RUN(knots);
    RUN(fjord);
    RUN(dice);
    RUN(clockwork);
    RUN(vase);
    RUN(orrery);
    RUN(porch);
    RUN(window);
    RUN(block);
    RUN(caustic);
    RUN(solids);
    RUN(cornell);
    RUN(marbles);
    RUN(shadow_volume);
    RUN(shadow_mapping);
    return check_status();
}
