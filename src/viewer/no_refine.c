/* no_refine.c - stands in for refine.c, pass.c, pace.c, gaze.c, fill.c and control.c in programs that draw spheres
 * alone: spans are never drawn pixel by pixel, and keys that move no light end the loop. */
#include "loop.h"

uint64_t tia_viewer_canvas_size(const struct loop *loop, bool sums)
{
    (void)loop;
    (void)sums;
    return 0;
}

void tia_viewer_set_canvas(struct loop *loop, void *memory, uint64_t size)
{
    (void)loop;
    (void)memory;
    (void)size;
}

bool tia_viewer_refines(const struct loop *loop)
{
    (void)loop;
    return false;
}

int tia_viewer_draw_passes(struct loop *loop, struct tia_frame *frame)
{
    (void)frame;
    return tia_viewer_draw_tiles(loop);
}

int tia_viewer_copy(struct loop *loop)
{
    return tia_viewer_draw_tiles(loop);
}

void tia_viewer_copy_last(struct loop *loop)
{
    (void)loop;
}

void tia_viewer_gaze(struct loop *loop)
{
    loop->gazes = false;
}

bool tia_viewer_point(struct loop *loop, const struct tia_event *event)
{
    (void)loop;
    (void)event;
    return false;
}

uint64_t tia_viewer_period_us(const struct loop *loop)
{
    (void)loop;
    return VIEWER_PERIOD_US;
}

uint64_t tia_viewer_whole_us(const struct loop *loop, const struct tia_frame *frame)
{
    (void)loop;
    return frame->draw_us;
}

bool tia_viewer_is_moving(const struct loop *loop)
{
    (void)loop;
    return false;
}

enum tia_effect tia_viewer_effect(const struct loop *loop, const struct tia_event *event)
{
    if (event->kind > TIA_EVENT_TAP || event->kind == TIA_EVENT_RELEASE)
        return TIA_EFFECT_NONE;
    return tia_viewer_lights(loop, event) ? TIA_EFFECT_CAMERA : TIA_EFFECT_END;
}

int tia_viewer_control(struct loop *loop, const struct tia_event *event)
{
    return tia_viewer_effect(loop, event) == TIA_EFFECT_END ? VIEWER_QUIT : TIA_OK;
}

bool tia_viewer_go_back(struct loop *loop)
{
    (void)loop;
    return false;
}

bool tia_viewer_joins(struct loop *loop, const struct tia_event *event)
{
    (void)loop;
    (void)event;
    return false;
}
