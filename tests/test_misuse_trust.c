/* Misuse of seals, comparisons and telltales. */
#include <tia/trust.h>

#include "misuse_scene.h"

static struct tia_seal seal;
static struct tia_sealed sealed;

static void prepare(void)
{
    misuse_prepare();
    sealed = (struct tia_sealed){.view = misuse_view_memory,
                                 .view_size = sizeof misuse_view_memory,
                                 .hits = misuse_memory,
                                 .hits_size = sizeof misuse_memory,
                                 .seal = &seal};
    CHECK_EQ(tia_view_seal(&sealed), TIA_OK);
}

static struct tia_sealed changed;
#define WITH(field, value) (changed = sealed, changed.field = (value), &changed)

TEST(misuse_of_seals)
{
    prepare();
    size_t need = tia_view_size(&misuse_scene, MISUSE_LIGHTS);

    REFUSES(tia_view_seal(NULL));
    REFUSES(tia_view_seal(WITH(view, NULL)));
    REFUSES(tia_view_seal(WITH(view, MISALIGNED(misuse_view_memory))));
    REFUSES(tia_view_seal(WITH(seal, NULL)));
    REFUSES(tia_view_seal(WITH(seal, MISALIGNED(&seal))));
    REFUSES(tia_view_seal(WITH(view_size, 0)));
    REFUSES(tia_view_seal(WITH(view_size, 7)));
    GIVES(TIA_ERR_MEMORY, tia_view_seal(WITH(view_size, need - 1)));
    GIVES(TIA_OK, tia_view_seal(WITH(view_size, need)));
    REFUSES(tia_view_check(NULL));
    REFUSES(tia_view_check(WITH(view, NULL)));
    REFUSES(tia_view_check(WITH(seal, NULL)));
    REFUSES(tia_view_check(WITH(view_size, 8)));
    GIVES(TIA_ERR_DAMAGED, tia_view_check(WITH(view_size, need)));
    GIVES(TIA_ERR_DAMAGED, (memset(&seal, 0, sizeof seal), tia_view_check(&sealed)));
    GIVES(TIA_ERR_DAMAGED, (memset(misuse_view_memory, 0xff, sizeof misuse_view_memory), tia_view_check(&sealed)));
    GIVES(TIA_OK, tia_view_check(&sealed));
    misuse_end();
}

/* A core with a `drawing` of its own, as a program may have. */
static int seal_other_core(bool own_drawing, const struct tia_simd *simd)
{
    static struct tia_core core;
    static uint64_t simd_memory[200000];

    core = tia_core_q16;
    core.drawing = own_drawing ? &tia_drawing : NULL;
    int status = core.view_init(&core, &misuse_view, misuse_view_memory, sizeof misuse_view_memory, &misuse_scene,
                                MISUSE_LIGHTS, MISUSE_W, MISUSE_H, NULL);
    if (!status && simd)
        status = tia_view_set_simd(misuse_view, simd, simd_memory, sizeof simd_memory);
    return status ? status : tia_view_seal(&sealed);
}

TEST(misuse_of_views_that_cannot_be_sealed)
{
    prepare();
    GIVES(TIA_ERR_UNSUPPORTED, seal_other_core(true, NULL));
    GIVES(TIA_OK, seal_other_core(false, NULL));
    if (tia_simd_best())
        GIVES(TIA_ERR_UNSUPPORTED, seal_other_core(false, tia_simd_best()));
    misuse_end();
}

TEST(misuse_of_checked_drawing)
{
    const struct tia_surface none = {NULL, 2, 2 * MISUSE_W};
    struct tia_light bad;

    prepare();
    memset(&bad, 0xff, sizeof bad);
    REFUSES(tia_view_draw_checked(NULL, misuse_frame, &misuse_surface, NULL));
    REFUSES(tia_view_draw_checked(WITH(hits, NULL), misuse_frame, &misuse_surface, NULL));
    REFUSES(tia_view_draw_checked(WITH(hits, MISALIGNED(misuse_memory)), misuse_frame, &misuse_surface, NULL));
    GIVES(TIA_ERR_MEMORY, tia_view_draw_checked(WITH(hits_size, 10), misuse_frame, &misuse_surface, NULL));
    REFUSES(tia_view_draw_checked(&sealed, misuse_frame, NULL, NULL));
    REFUSES(tia_view_draw_checked(&sealed, misuse_frame, &none, NULL));
    REFUSES(tia_view_draw_checked(&sealed, TILE(0, 0, 0, 0), &misuse_surface, NULL));
    REFUSES(tia_view_draw_checked(&sealed, TILE(1, 0, MISUSE_W, MISUSE_H), &misuse_surface, NULL));
    GIVES(TIA_OK, tia_view_draw_checked(&sealed, misuse_frame, &misuse_surface, NULL));
    REFUSES(tia_view_set_lights_checked(NULL, NULL, 0));
    GIVES(TIA_ERR_RANGE, tia_view_set_lights_checked(&sealed, &bad, 1));
    GIVES(TIA_ERR_MEMORY, tia_view_set_lights_checked(&sealed, misuse_scene.lights, MISUSE_LIGHTS + 1));
    GIVES(TIA_OK, tia_view_set_lights_checked(&sealed, NULL, 0));
    misuse_end();
}

static int read_black(void *ctx, struct tia_tile tile, tia_rgb565 *pixels)
{
    memset(pixels, 0, 2 * (size_t)tile.width);
    return ctx ? TIA_ERR_DEVICE : TIA_OK;
}

TEST(misuse_of_comparisons)
{
    const struct tia_readback none = {NULL, NULL}, black = {read_black, NULL}, broken = {read_black, &sealed};
    struct tia_difference difference;
    tia_rgb565 *pixels = misuse_pixels;
    const size_t count = 2 * MISUSE_W;

    prepare();
    REFUSES(tia_view_compare(NULL, misuse_frame, false, &black, pixels, count, &difference));
    REFUSES(tia_view_compare(&sealed, misuse_frame, false, NULL, pixels, count, &difference));
    REFUSES(tia_view_compare(&sealed, misuse_frame, false, &none, pixels, count, &difference));
    REFUSES(tia_view_compare(&sealed, misuse_frame, false, &black, NULL, count, &difference));
    REFUSES(tia_view_compare(&sealed, TILE(0, 0, 0, 1), false, &black, pixels, count, &difference));
    REFUSES(tia_view_compare(&sealed, TILE(0, 0, 1, 0), false, &black, pixels, count, &difference));
    REFUSES(tia_view_compare(&sealed, TILE(9, 0, MISUSE_W, 1), false, &black, pixels, count, &difference));
    REFUSES(tia_view_compare(&sealed, TILE(0, 65535, 1, 65535), false, &black, pixels, count, &difference));
    REFUSES(tia_view_compare(WITH(hits, NULL), misuse_frame, false, &black, pixels, count, &difference));
    GIVES(TIA_ERR_MEMORY, tia_view_compare(&sealed, misuse_frame, false, &black, pixels, count - 1, &difference));
    GIVES(TIA_ERR_MEMORY, tia_view_compare(WITH(hits_size, 8), misuse_frame, false, &black, pixels, count, NULL));
    GIVES(TIA_ERR_DEVICE, tia_view_compare(&sealed, misuse_frame, false, &broken, pixels, count, NULL));
    GIVES(TIA_ERR_DAMAGED, tia_view_compare(&sealed, misuse_frame, false, &black, pixels, count, NULL));
    misuse_end();
}

static const uint32_t crcs[] = {0, 0};
static const uint16_t keys[] = {'a'};
static const struct tia_telltale rows[] = {{"all", {0, 0, MISUSE_W, MISUSE_H}, crcs}};
static const struct tia_telltales good = {MISUSE_W, MISUSE_H, rows, keys, 1, 1};
static struct tia_telltales other;
#define ALL_WITH(field, value) (other = good, other.field = (value), &other)

TEST(misuse_of_telltales)
{
    const struct tia_surface none = {NULL, 2, 2 * MISUSE_W};
    static struct tia_telltale_sum sums[1];

    REFUSES(tia_telltales_add(NULL, sums, misuse_frame, &misuse_surface));
    REFUSES(tia_telltales_add(&good, NULL, misuse_frame, &misuse_surface));
    REFUSES(tia_telltales_add(&good, sums, misuse_frame, NULL));
    REFUSES(tia_telltales_add(&good, sums, misuse_frame, &none));
    REFUSES(tia_telltales_add(&good, sums, TILE(0, 0, 0, 1), &misuse_surface));
    REFUSES(tia_telltales_add(&good, sums, TILE(0, 0, MISUSE_W + 1, 1), &misuse_surface));
    REFUSES(tia_telltales_add(&good, sums, TILE(65535, 65535, 65535, 65535), &misuse_surface));
    REFUSES(tia_telltales_add(ALL_WITH(telltales, NULL), sums, misuse_frame, &misuse_surface));
    REFUSES(tia_telltales_add(ALL_WITH(telltale_count, 0), sums, misuse_frame, &misuse_surface));
    REFUSES(tia_telltales_add(ALL_WITH(keys, NULL), sums, misuse_frame, &misuse_surface));
    GIVES(TIA_OK, tia_telltales_add(&good, sums, misuse_frame, &misuse_surface));
    REFUSES(tia_telltales_check(NULL, sums, 0, NULL));
    REFUSES(tia_telltales_check(&good, NULL, 0, NULL));
    REFUSES(tia_telltales_check(&good, sums, 2, NULL));
    REFUSES(tia_telltales_check(&good, sums, UINT32_MAX, NULL));
    GIVES(TIA_ERR_DAMAGED, tia_telltales_check(&good, sums, 1, NULL));
    misuse_end();
}

int main(void)
{
    RUN(misuse_of_seals);
    RUN(misuse_of_views_that_cannot_be_sealed);
    RUN(misuse_of_checked_drawing);
    RUN(misuse_of_comparisons);
    RUN(misuse_of_telltales);
    return check_status();
}
