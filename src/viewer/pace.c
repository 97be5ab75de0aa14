/* pace.c - limits the detail of frames in motion, so that they are shown in time. */
#include "loop.h"

uint64_t tia_viewer_period_us(const struct loop *loop)
{
    const uint32_t *pace = loop->viewer->pacing.pace;

    return pace[0] ? (UINT64_C(1000000) * pace[1] + pace[0] - 1) / pace[0] : VIEWER_PERIOD_US;
}

bool tia_viewer_is_moving(const struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;
    bool plays = loop->plays && !loop->state.paused && loop->end > v->pacing.time;

    return v->pacing.pace[0] && v->ports.clock && (plays || tia_viewer_repeat_us(loop));
}

/* Returns the number of samples that the pass adds; each costs as much as a pixel of an earlier pass, which has one
 * sample. */
static uint64_t more_samples(const struct loop *loop)
{
    uint64_t pixels = 0;

    for (unsigned i = 0; i < VIEWER_PASSES; i++)
        pixels += loop->pass_pixels[i];
    return pixels * (tia_viewer_samples(loop, loop->pass + 1) - tia_viewer_samples(loop, loop->pass));
}

/* Returns the expected number of pixels of the pass: that of the last frame or, if it is unknown, three for each pixel
 * drawn before. Before pass p, above 0, 4^-(VIEWER_PASSES - p) of the picture's pixels are drawn. */
static uint64_t pass_pixels(const struct loop *loop)
{
    uint64_t all = (uint64_t)loop->mode.width * loop->mode.height;

    if (loop->pass >= VIEWER_PASSES)
        return more_samples(loop);
    if (loop->pass_pixels[loop->pass])
        return loop->pass_pixels[loop->pass];
    return (loop->pass ? 3 * all : all) >> 2 * (loop->pass ? VIEWER_PASSES - loop->pass : VIEWER_PASSES - 1);
}

/* Returns the time that the frame took; for an unfinished frame, the time that all its samples would take at the
 * measured cost, if that is longer. */
uint64_t tia_viewer_whole_us(const struct loop *loop, const struct tia_frame *frame)
{
    uint64_t pixels = (uint64_t)loop->mode.width * loop->mode.height,
             all = pixels * loop->cost_ns / 1000 * viewer_spp(loop);

    return !loop->unfinished || all < frame->draw_us ? frame->draw_us : all;
}

/* True if the period has time for the pass and an eighth more, and for showing the picture, which is assumed to take as
 * long as the last time. The margin is there because a missing pass is better than a late frame. */
bool tia_viewer_has_time(const struct loop *loop)
{
    uint64_t period = tia_viewer_period_us(loop), spent = viewer_now(loop) - loop->begun_us + loop->show_cost_us;
    uint64_t pass = pass_pixels(loop) * loop->cost_ns / 1000;

    return spent + pass + pass / 8 <= period;
}

void tia_viewer_learn(struct loop *loop, uint32_t pixels, uint64_t us)
{
    uint64_t ns = pixels ? us * 1000 / pixels : 0;

    if (loop->pass >= VIEWER_PASSES)
        return;
    loop->pass_pixels[loop->pass] = pixels;
    if (pixels)
        loop->cost_ns = (uint32_t)(ns < 1 ? 1 : ns < UINT32_MAX ? ns : UINT32_MAX);
}
