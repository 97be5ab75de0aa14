/* Exact pixels of a view, and the comparison of pictures with them: a broken pixel is found at its place. */
#include <stdlib.h>
#include <tia/debug.h>
#include <tia/tia.h>

#include "check.h"
#include "common/corpus/corpus.h"
#include "common/corpus/exact_measure.h"
#include "workers_in_turn.h"

enum { W = 61, H = 37, BROKEN_X = 41, BROKEN_Y = 23 };

static int draw_broken(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile,
                       const struct tia_surface *surface, const struct tia_options *options)
{
    int status = tia_drawing.render(view, hits, tile, surface, options);

    if (tile.y <= BROKEN_Y && BROKEN_Y < tile.y + tile.height)
        *(tia_rgb565 *)(void *)((char *)surface->pixels + surface->pitch * (BROKEN_Y - tile.y) +
                                surface->step * (BROKEN_X - tile.x)) ^= 1;
    return status;
}

static const struct tia_workers workers = {
    .run = run_in_turn, .enter = enter_in_turn, .leave = leave_in_turn, .count = 1};

/* Measures key a's frame with plain C and, last, with a core that breaks a pixel; returns the number of drawers. */
static unsigned measure_broken(uint32_t step, struct exact_tally *tally)
{
    struct corpus_scene s;
    struct tia_drawing drawing = tia_drawing;
    struct tia_core core = tia_core_q16;
    struct exact_measure what = {.width = W, .height = H, .step = step, .workers = &workers};

    drawing.render = draw_broken;
    core.drawing = &drawing;
    CHECK_EQ(corpus_thesis(&s, "a", W, H), TIA_OK);
    what.scene = &s.scene;
    exact_drawers(&what);
    what.drawer_count = EXACT_DRAWERS - 1 < what.drawer_count ? EXACT_DRAWERS - 1 : what.drawer_count;
    exact_add(&what, &core);
    CHECK_EQ(exact_measure(&what, tally), TIA_OK);
    return what.drawer_count;
}

TEST(a_broken_pixel_is_noticed)
{
    struct exact_tally tally;
    unsigned count = measure_broken(1, &tally);
    const struct exact_drawn *broken = &tally.by[count - 1];

    CHECK_EQ(tally.pixels, W * H);
    for (unsigned n = 0; n < count - 1; n++)
        CHECK_EQ(tally.by[n].differ, 0);
    CHECK_EQ(broken->pixels, W * H);
    CHECK_EQ(broken->differ, 1);
    CHECK_EQ(broken->x, BROKEN_X);
    CHECK_EQ(broken->y, BROKEN_Y);
    CHECK_EQ(broken->got, broken->want ^ 1);
}

TEST(every_nth_pixel_is_compared)
{
    for (uint32_t step = 1; step < W * H + 2; step += 1 + step / 3) {
        struct exact_tally tally;
        unsigned count = measure_broken(step, &tally);
        CHECK_EQ(tally.pixels, (W * H + step - 1) / step);
        CHECK_EQ(tally.by[0].pixels, tally.pixels);
        CHECK_EQ(tally.by[count - 1].differ, (BROKEN_Y * W + BROKEN_X) % step == 0);
    }
}

TEST(other_scenes_have_no_exact_picture)
{
    struct corpus_scene s;
    struct exact_measure what = {.width = W, .height = H, .step = 1, .workers = &workers};
    struct exact_tally tally;

    corpus_random(&s, 7, 0);
    what.scene = &s.scene;
    exact_drawers(&what);
    CHECK_EQ(exact_measure(&what, &tally), TIA_OK);
    s.materials[1].mirror.r = TIA_Q30_ONE / 2;
    CHECK_EQ(exact_measure(&what, &tally), TIA_ERR_UNSUPPORTED);
    s.materials[1].mirror.r = -1;
    CHECK_EQ(exact_measure(&what, &tally), TIA_ERR_RANGE);
}

TEST(wrong_calls_are_refused)
{
    struct corpus_scene s;
    struct tia_view *view;
    struct tia_exact pixels[2] = {{.bits = 7}, {.bits = 7}};

    CHECK_EQ(corpus_thesis(&s, "a", W, H), TIA_OK);
    size_t size = tia_view_size(&s.scene, s.scene.light_count);
    void *memory = malloc(size);
    CHECK_EQ(tia_view_init(&view, memory, size, &s.scene, s.scene.light_count, W, H, NULL), TIA_OK);
    CHECK_EQ(tia_view_exact(NULL, 0, 1, 1, false, pixels), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_view_exact(view, 0, 1, 1, false, NULL), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_view_exact(view, 0, 0, 1, false, pixels), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_view_exact(view, W * H, 1, 1, false, pixels), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_view_exact(view, W * H - 1, 1, 2, false, pixels), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_view_exact(view, UINT32_MAX, UINT32_MAX, UINT32_MAX, false, pixels), TIA_ERR_ARGUMENT);
    CHECK_EQ(pixels[0].bits, 7);
    CHECK_EQ(tia_view_exact(view, W * H, 1, 0, false, pixels), TIA_OK);
    CHECK_EQ(tia_view_exact(view, W * H - 1, 1, 1, false, pixels), TIA_OK);
    CHECK_EQ(pixels[0].bits, 64);
    CHECK_EQ(pixels[1].bits, 7);
    free(memory);
}

int main(void)
{
    RUN(a_broken_pixel_is_noticed);
    RUN(every_nth_pixel_is_compared);
    RUN(other_scenes_have_no_exact_picture);
    RUN(wrong_calls_are_refused);
    return check_status();
}
