/* Misuse of estimators, the denoiser, tones, text and the gaze. */
#include <limits.h>
#include <tia/debug.h>
#include <tia/denoise.h>
#include <tia/tone.h>

#include "misuse_scene.h"
#include "viewer/acuity.h"

static const struct tia_estimator *const q16 = &tia_estimator_q16;
static struct tia_view *paths;
static struct tia_sum sums[MISUSE_W * MISUSE_H];
static struct tia_guide guides[MISUSE_W * MISUSE_H];
static uint64_t squares[MISUSE_W * MISUSE_H];
static const struct tia_gathered gathered = {sums, guides, squares, MISUSE_W};

static void prepare(void)
{
    static uint64_t memory[4000];
    static struct tia_scene scene;

    misuse_prepare();
    scene = misuse_scene;
    scene.integration.integrator = TIA_PATHS;
    CHECK_EQ(misuse_init(&paths, memory, sizeof memory, &scene, MISUSE_W, MISUSE_H), TIA_OK);
}

static int gather_into(struct tia_gathered into)
{
    return q16->gather(paths, TILE(0, 0, 2, 2), 0, 1, &into);
}

static int show_on(struct tia_surface surface)
{
    return q16->show(paths, TILE(0, 0, 4, 1), sums, 1, &surface, false);
}

TEST(misuse_of_estimators)
{
    const struct tia_tile tile = {0, 0, 4, 1};

    prepare();
    REFUSES(q16->sample(NULL, tile, 0, 1, sums, MISUSE_W));
    REFUSES(q16->sample(paths, tile, 0, 1, NULL, MISUSE_W));
    REFUSES(q16->sample(paths, TILE(0, 0, 0, 1), 0, 1, sums, MISUSE_W));
    REFUSES(q16->sample(paths, TILE(65535, 0, 65535, 1), 0, 1, sums, MISUSE_W));
    REFUSES(q16->sample(paths, TILE(1, 0, MISUSE_W, 1), 0, 1, sums, MISUSE_W));
    REFUSES(q16->sample(paths, tile, 2, 1, sums, MISUSE_W));
    REFUSES(q16->sample(paths, tile, 0, TIA_SPP_MAX + 1, sums, MISUSE_W));
    GIVES(TIA_ERR_UNSUPPORTED, q16->sample(misuse_view, tile, 0, 1, sums, MISUSE_W));
    REFUSES(q16->gather(NULL, tile, 0, 1, &gathered));
    REFUSES(q16->gather(paths, tile, 0, 1, NULL));
    REFUSES(gather_into((struct tia_gathered){NULL, guides, squares, MISUSE_W}));
    GIVES(TIA_OK, gather_into((struct tia_gathered){sums, NULL, NULL, MISUSE_W}));
    GIVES(TIA_NO_OBJECT, q16->enclosing(NULL, 0));
    GIVES(TIA_NO_OBJECT, q16->enclosing(misuse_view, 0));
    GIVES(TIA_NO_OBJECT, q16->enclosing(paths, 99999));
    GIVES(TIA_NO_OBJECT, q16->enclosing(paths, UINT32_MAX));
    REFUSES(q16->show(NULL, tile, sums, 1, &misuse_surface, false));
    REFUSES(q16->show(paths, tile, NULL, 1, &misuse_surface, false));
    REFUSES(q16->show(paths, tile, sums, 1, NULL, false));
    REFUSES(q16->show(paths, tile, sums, 0, &misuse_surface, false));
    REFUSES(q16->show(paths, tile, sums, TIA_SPP_MAX + 1, &misuse_surface, false));
    REFUSES(q16->show(paths, TILE(0, 0, 4, 2), sums, 1, &misuse_surface, false));
    REFUSES(q16->show(paths, TILE(0, MISUSE_H, 4, 1), sums, 1, &misuse_surface, false));
    REFUSES(show_on((struct tia_surface){.pixels = NULL, .step = 2, .pitch = 2}));
    REFUSES(show_on((struct tia_surface){.pixels = MISALIGNED(misuse_memory), .step = 2, .pitch = 2}));
    REFUSES(show_on((struct tia_surface){.pixels = misuse_pixels, .step = 1, .pitch = 2}));
    GIVES(TIA_OK, q16->show(paths, tile, sums, 1, &misuse_surface, false));
    misuse_end();
}

static int put(struct tia_denoiser *d, struct tia_gathered from)
{
    return tia_denoise_put(d, TILE(0, 0, 4, 4), &from, 1);
}

TEST(misuse_of_the_denoiser)
{
    struct tia_denoiser *d = NULL, *made = NULL;
    size_t need = tia_denoise_size(8, 8);

    prepare();
    REFUSES(tia_denoise_init(NULL, misuse_memory, sizeof misuse_memory, 8, 8));
    REFUSES(tia_denoise_init(&made, NULL, sizeof misuse_memory, 8, 8));
    REFUSES(tia_denoise_init(&made, MISALIGNED(misuse_memory), sizeof misuse_memory - 8, 8, 8));
    REFUSES(tia_denoise_init(&made, misuse_memory, sizeof misuse_memory, 0, 8));
    REFUSES(tia_denoise_init(&made, misuse_memory, sizeof misuse_memory, 8, TIA_SIZE_MAX + 1));
    GIVES(TIA_ERR_MEMORY, tia_denoise_init(&made, misuse_memory, need - 1, 8, 8));
    GIVES(SIZE_MAX, (intmax_t)tia_denoise_size(UINT_MAX, 8));
    memset(misuse_memory, 0x5a, sizeof misuse_memory);
    CHECK_EQ(tia_denoise_init(&d, misuse_memory, sizeof misuse_memory, 8, 8), TIA_OK);
    REFUSES(tia_denoise_put(NULL, TILE(0, 0, 4, 4), &gathered, 1));
    REFUSES(tia_denoise_put(d, TILE(0, 0, 4, 4), NULL, 1));
    REFUSES(put(d, (struct tia_gathered){NULL, guides, squares, MISUSE_W}));
    REFUSES(put(d, (struct tia_gathered){sums, NULL, squares, MISUSE_W}));
    REFUSES(put(d, (struct tia_gathered){sums, guides, NULL, MISUSE_W}));
    REFUSES(tia_denoise_put(d, TILE(4, 4, 8, 8), &gathered, 1));
    REFUSES(tia_denoise_put(d, TILE(0, 0, 4, 4), &gathered, 0));
    REFUSES(tia_denoise_put(d, TILE(0, 0, 4, 4), &gathered, TIA_SPP_MAX + 1));
    REFUSES(tia_denoise_pass(NULL, 0, TILE(0, 0, 8, 8)));
    REFUSES(tia_denoise_pass(d, TIA_DENOISE_PASSES, TILE(0, 0, 8, 8)));
    REFUSES(tia_denoise_pass(d, UINT_MAX, TILE(0, 0, 8, 8)));
    REFUSES(tia_denoise_pass(d, 0, TILE(4, 4, 8, 8)));
    REFUSES(tia_denoise_pass(d, 0, TILE(0, 0, 0, 0)));
    REFUSES(tia_denoise_get(NULL, TILE(0, 0, 8, 8), 1, sums, 8));
    REFUSES(tia_denoise_get(d, TILE(0, 0, 8, 8), 1, NULL, 8));
    REFUSES(tia_denoise_get(d, TILE(0, 0, 8, 8), 0, sums, 8));
    REFUSES(tia_denoise_get(d, TILE(0, 0, 9, 8), 1, sums, 8));
    /* pixels are black before any samples are put in */
    GIVES(TIA_OK, tia_denoise_get(d, TILE(0, 0, 8, 8), 1, sums, 8) ? 1 : sums[5].rgb[0] | sums[63].rgb[2]);
    GIVES(TIA_OK, tia_denoise_pass(d, 0, TILE(0, 0, 8, 8)) ? 1 : tia_denoise_get(d, TILE(7, 7, 1, 1), 1, sums, 8));
    misuse_end();
}

static int64_t shown(int guide, struct tia_gathered from, uint32_t count)
{
    struct tia_sum sum = tia_guide_shown((enum tia_shown_guide)guide, &from, 0, count);

    return sum.rgb[0] | sum.rgb[1] | sum.rgb[2];
}

TEST(misuse_of_guides)
{
    const struct tia_sum sum = {{1, 2, 3}};

    GIVES(0, tia_standard_error(NULL, 1, 1));
    GIVES(0, tia_standard_error(&sum, UINT64_MAX, 0));
    GIVES(0, tia_guide_shown(TIA_SHOW_NORMAL, NULL, 0, 1).rgb[0]);
    guides[0].normal[0] = guides[0].albedo[0] = guides[0].depth = 1 << 24;
    for (int guide = TIA_SHOW_NOTHING; guide <= TIA_SHOW_ERROR; guide++) {
        GIVES(0, shown(guide, (struct tia_gathered){NULL, guides, squares, 1}, 1));
        GIVES(0, shown(guide, (struct tia_gathered){sums, NULL, squares, 1}, 1));
        GIVES(guide == TIA_SHOW_ERROR, shown(guide, (struct tia_gathered){sums, guides, NULL, 1}, 1) == 0);
        GIVES(0, shown(guide, gathered, 0));
        GIVES(0, shown(guide, gathered, UINT32_MAX));
    }
    GIVES(1, shown(99, gathered, 1) == 1 << 24); /* an unknown guide counts as the albedo */
    misuse_end();
}

static uint32_t exposed(tia_q16 exposure, int64_t sum, uint32_t count)
{
    struct tia_exposure e = tia_exposure_of(exposure);

    return tia_exposed(&e, sum, count);
}

TEST(misuse_of_tones)
{
    GIVES(0, tia_exposed(NULL, 1, 1));
    GIVES(0, exposed(0, INT64_MAX, 0));
    GIVES(0, exposed(INT32_MIN, INT64_MIN, 1));
    GIVES(UINT32_MAX, exposed(INT32_MAX, INT64_MAX, 1));
    GIVES(UINT32_MAX, exposed(INT32_MAX, 1 << 24, 1));
    GIVES(1, exposed(INT32_MIN, INT64_C(1) << 38, 1) == exposed(-TIA_EXPOSURE_MAX, INT64_C(1) << 38, 1));
    GIVES(TIA_TONE_LINEAR, tia_tone_of(NULL));
    GIVES(0, tia_tone_level(TIA_TONE_LINEAR, UINT32_MAX, 0));
    GIVES(0, tia_tone_level(TIA_TONE_LINEAR, UINT32_MAX, 17));
    GIVES(0, tia_tone_level(TIA_TONE_LINEAR, UINT32_MAX, UINT_MAX));
    GIVES(0, tia_tone_level(TIA_TONE_SRGB, UINT32_MAX, 0));
    GIVES(0, tia_tone_level(TIA_TONE_SRGB, UINT32_MAX, 7));
    GIVES(0, tia_tone_level(TIA_TONE_SRGB, UINT32_MAX, 16));
    GIVES(0, tia_tone_level((enum tia_tone)77, UINT32_MAX, 99));
    GIVES(255, tia_tone_level((enum tia_tone)77, UINT32_MAX, 8)); /* an unknown tone counts as linear */
    misuse_end();
}

static int64_t text_pixels(struct tia_text text)
{
    struct tia_tile area = tia_text_area(&text, MISUSE_W, MISUSE_H);

    return (int64_t)area.width * area.height;
}

static int write_on(struct tia_surface surface)
{
    const struct tia_text text = {"x", 0, 0, 1, 1, 2};

    return tia_text_draw(&text, TILE(0, 0, 8, 8), &surface);
}

TEST(misuse_of_text)
{
    const struct tia_text text = {"x\xff\ny", 1, 1, 1, 1, 2}, none = {.scale = 1},
                          far = {"x", 65535, 65535, 65535, 1, 2};
    const struct tia_text flat = {"x", 0, 0, 0, 1, 2};

    GIVES(0, tia_text_area(NULL, 8, 8).width);
    GIVES(0, text_pixels(none));
    GIVES(0, text_pixels(far));
    GIVES(0, text_pixels(flat));
    REFUSES(tia_text_draw(NULL, misuse_frame, &misuse_surface));
    REFUSES(tia_text_draw(&none, misuse_frame, &misuse_surface));
    REFUSES(tia_text_draw(&text, misuse_frame, NULL));
    REFUSES(write_on((struct tia_surface){.pixels = NULL, .step = 2, .pitch = 2}));
    REFUSES(write_on((struct tia_surface){.pixels = MISALIGNED(misuse_memory), .step = 2, .pitch = 2}));
    REFUSES(write_on((struct tia_surface){.pixels = misuse_pixels, .step = 2, .pitch = 1}));
    GIVES(TIA_OK, tia_text_draw(&far, misuse_frame, &misuse_surface));
    GIVES(TIA_OK, tia_text_draw(&flat, misuse_frame, &misuse_surface));
    GIVES(TIA_OK, tia_text_draw(&text, misuse_frame, &misuse_surface));
    GIVES(7, tia_crc32(7, NULL, 5));
    misuse_end();
}

static bool set_up(struct tia_gaze gaze, unsigned width, unsigned height)
{
    struct tia_acuity acuity;

    return tia_acuity_init(&acuity, &gaze, width, height);
}

#define GAZE(angle) ((struct tia_gaze){4, 4, angle, TIA_GAZE_W0, TIA_GAZE_M, false})

TEST(misuse_of_the_gaze)
{
    const struct tia_gaze gaze = GAZE(TIA_Q16(90));
    struct tia_acuity acuity, made;

    CHECK(tia_acuity_init(&acuity, &gaze, 640, 480));
    GIVES(0, tia_acuity_init(NULL, &gaze, 640, 480));
    GIVES(0, tia_acuity_init(&made, NULL, 640, 480));
    GIVES(0, set_up(gaze, 0, 0));
    GIVES(0, set_up(gaze, UINT_MAX, 480));
    GIVES(0, set_up(gaze, 640, TIA_SIZE_MAX + 1));
    GIVES(0, set_up(GAZE(INT32_MIN), 640, 480));
    GIVES(0, set_up(GAZE(-1), 640, 480));
    GIVES(0, set_up(GAZE(1), 640, 480));
    GIVES(0, set_up(GAZE(INT32_MAX), 640, 480));
    GIVES(0, set_up((struct tia_gaze){65535, 65535, TIA_Q16(90), UINT32_MAX, UINT32_MAX, true}, 640, 480));
    GIVES(0, set_up((struct tia_gaze){4, 4, TIA_Q16(90), 0, 0, true}, 640, 480));
    GIVES(1, tia_acuity_block(NULL, 0, 0));
    GIVES(1, tia_acuity_block(&acuity, 640, 0));
    GIVES(1, tia_acuity_block(&acuity, UINT_MAX, UINT_MAX));
    GIVES(1, tia_acuity_block(&acuity, 639, 479) > 1);
    misuse_end();
}

int main(void)
{
    RUN(misuse_of_estimators);
    RUN(misuse_of_the_denoiser);
    RUN(misuse_of_guides);
    RUN(misuse_of_tones);
    RUN(misuse_of_text);
    RUN(misuse_of_the_gaze);
    return check_status();
}
