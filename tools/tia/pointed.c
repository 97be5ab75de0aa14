#include "pointed.h"

static int pointed_open(void *ctx)
{
    const struct pointed *pointed = ctx;
    return pointed->input->open(pointed->input_ctx);
}

static unsigned inside(int32_t part, unsigned screen, unsigned from, unsigned size)
{
    unsigned at = (unsigned)((uint32_t)part * (uint64_t)screen >> 16);

    return at < from ? 0 : at - from < size ? at - from : size - 1;
}

/* Returns the position of the middle of pixel `at`, in 2^-16 of `size` pixels. */
static int32_t part_of(unsigned at, unsigned size)
{
    return (int32_t)((2 * at + 1) * UINT32_C(32768) / size);
}

static void turn_place(const struct letterbox *letterbox, struct tia_event *event)
{
    const struct tia_tile *place = &letterbox->place;
    struct rotation back = rotation_inverse(&letterbox->rotation);

    if (place->width == 0 || place->height == 0)
        return;
    struct tia_tile pixel = {(uint16_t)inside(event->x, letterbox->mode.width, place->x, place->width),
                             (uint16_t)inside(event->y, letterbox->mode.height, place->y, place->height), 1, 1};
    pixel = rotation_tile(&back, pixel);
    event->x = part_of(pixel.x, letterbox->rotation.width);
    event->y = part_of(pixel.y, letterbox->rotation.height);
}

/* Rotates a movement on the screen to one in the picture, which is rotated clockwise: at 90 degrees, right on the
 * screen is up in the picture. */
static void turn_way(unsigned degrees, struct tia_event *event)
{
    int32_t x = event->x, y = event->y;

    event->x = degrees == 90 ? y : degrees == 180 ? -x : degrees == 270 ? -y : x;
    event->y = degrees == 90 ? -x : degrees == 180 ? -y : degrees == 270 ? x : y;
}

static int pointed_poll(void *ctx, struct tia_event *event)
{
    const struct pointed *pointed = ctx;
    if (pointed->watch && file_watch_fires(pointed->watch)) {
        *event = (struct tia_event){.kind = TIA_EVENT_TAP, .key = MOVE_CHANGED};
        return 1;
    }
    int status = pointed->input->poll(pointed->input_ctx, event);

    if (status > 0 && event->kind == TIA_EVENT_TAP && !event->shift)
        event->key = moves_scroll_key(pointed->moves, event->key);
    if (status > 0 && event->kind == TIA_EVENT_POINT)
        turn_place(pointed->letterbox, event);
    if (status > 0 && event->kind == TIA_EVENT_MOVE)
        turn_way(pointed->letterbox->degrees, event);
    return status;
}

static int pointed_wait(void *ctx, int timeout_ms)
{
    const struct pointed *pointed = ctx;
    return pointed->input->wait(pointed->input_ctx, timeout_ms);
}

static void pointed_close(void *ctx)
{
    const struct pointed *pointed = ctx;
    pointed->input->close(pointed->input_ctx);
}

const struct tia_input pointed_input = {pointed_open, pointed_poll, pointed_wait, pointed_close};
