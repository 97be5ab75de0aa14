/* gaze.c - the direction of the gaze. */
#include "loop.h"

void tia_viewer_gaze(struct loop *loop)
{
    loop->gazes = tia_acuity_init(&loop->acuity, &loop->gaze, loop->mode.width, loop->mode.height);
}

static uint16_t moved(uint16_t at, int32_t by, uint16_t size)
{
    int32_t to = (int32_t)at + by;

    return (uint16_t)(to < 0 ? 0 : to < size ? to : size - 1);
}

/* Moves the gaze; all pixels are then traced again, since pixels that were left out have no hits. */
bool tia_viewer_point(struct loop *loop, const struct tia_event *event)
{
    const struct tia_mode *mode = &loop->mode;
    struct tia_gaze *gaze = &loop->gaze, before = *gaze;

    if (!gaze->view_angle || !loop->canvas)
        return false;
    if (event->kind == TIA_EVENT_POINT) {
        gaze->x = (uint16_t)((uint32_t)event->x * mode->width >> 16);
        gaze->y = (uint16_t)((uint32_t)event->y * mode->height >> 16);
    } else {
        gaze->x = moved(gaze->x, event->x, mode->width);
        gaze->y = moved(gaze->y, event->y, mode->height);
    }
    if (gaze->x == before.x && gaze->y == before.y)
        return false;
    tia_viewer_gaze(loop);
    loop->traced = 0;
    loop->changed = true;
    return true;
}
