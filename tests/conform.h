/* conform.h - the test suite of every display, independent of its device. */
#ifndef TESTS_CONFORM_H
#define TESTS_CONFORM_H

#include <pthread.h>

#include <tia/port.h>

#include "check.h"

/* The display under test. */
struct subject {
    const struct tia_display *ops;
    void *ctx;
    const char *why;
    /* Returns pixel (x, y) of the frame presented last, as RGB565; NULL if pixels cannot be read. */
    tia_rgb565 (*pixel)(void *arg, unsigned x, unsigned y);
    /* NULL, or waits until `frames` frames have been shown, not counting those that changed nothing */
    void (*settle)(void *arg, unsigned frames);
    void *arg;
    unsigned frames, last;
};

static struct subject subject;
static struct tia_mode mode;

/* Returns the expected colour of a pixel. 40503 is odd, so that all colours occur before one is repeated, and
 * neighbours differ. */
static inline tia_rgb565 wanted(unsigned x, unsigned y, unsigned frame)
{
    return (tia_rgb565)((x + y * mode.width + frame * 7919) * 40503u);
}

/* ---- frames ---- */

static inline void fill(const struct tia_surface *surface, struct tia_tile tile, unsigned frame)
{
    for (unsigned y = 0; y < tile.height; y++)
        for (unsigned x = 0; x < tile.width; x++) {
            char *at = (char *)surface->pixels + (ptrdiff_t)y * surface->pitch + (ptrdiff_t)x * surface->step;
            *(tia_rgb565 *)(void *)at = wanted(tile.x + x, tile.y + y, frame);
        }
}

static inline bool draw_tile(struct tia_tile tile, unsigned frame)
{
    struct tia_surface surface = {0};

    if (subject.ops->acquire(subject.ctx, tile, &surface) || !surface.pixels || surface.step % 2 || surface.pitch % 2)
        return false;
    fill(&surface, tile, frame);
    return !subject.ops->submit(subject.ctx, tile);
}

/* The picture cut into tiles. The mode allows their size, and the picture's size is not a multiple of it. */
struct cut {
    unsigned width, height, columns, rows, frame, first, every;
    bool failed;
};

static inline struct cut cut_for(unsigned frame)
{
    struct cut cut = {.width = 37, .height = 19, .frame = frame, .every = 1};

    if (mode.tile_width && mode.tile_width < cut.width)
        cut.width = mode.tile_width;
    if (mode.tile_height && mode.tile_height < cut.height)
        cut.height = mode.tile_height;
    cut.columns = (mode.width + cut.width - 1) / cut.width;
    cut.rows = (mode.height + cut.height - 1) / cut.height;
    return cut;
}

static inline unsigned smaller(unsigned a, unsigned b)
{
    return a < b ? a : b;
}

/* Draws every `every`th tile, beginning with number `first`, in reverse order. */
static inline void *draw_cut(void *arg)
{
    struct cut *cut = arg;

    for (unsigned n = cut->first; n < cut->columns * cut->rows; n += cut->every) {
        unsigned i = cut->columns * cut->rows - 1 - n;
        unsigned x = i % cut->columns * cut->width, y = i / cut->columns * cut->height;
        struct tia_tile tile = {(uint16_t)x, (uint16_t)y, (uint16_t)smaller(cut->width, mode.width - x),
                                (uint16_t)smaller(cut->height, mode.height - y)};
        cut->failed |= !draw_tile(tile, cut->frame);
    }
    return NULL;
}

static inline void check_frame(unsigned frame)
{
    if (subject.settle)
        subject.settle(subject.arg, subject.frames);
    for (unsigned y = 0; subject.pixel && y < mode.height; y++)
        for (unsigned x = 0; x < mode.width; x++)
            CHECK_MSG(subject.pixel(subject.arg, x, y) == wanted(x, y, frame), "frame %u: %u,%u is %04x, not %04x",
                      frame, x, y, subject.pixel(subject.arg, x, y), wanted(x, y, frame));
}

static inline void present(unsigned frame)
{
    int status = subject.ops->present(subject.ctx);

    while (status == TIA_BUSY)
        status = subject.ops->go_on(subject.ctx);
    CHECK_MSG(!status, "frame %u: present: %s", frame, subject.why);
    subject.frames += frame != subject.last;
    subject.last = frame;
    check_frame(frame);
}

static inline void one_thread(unsigned frame)
{
    struct cut cut = cut_for(frame);

    (void)draw_cut(&cut);
    CHECK_MSG(!cut.failed, "frame %u: a tile failed: %s", frame, subject.why);
    present(frame);
}

static inline void two_threads(unsigned frame)
{
    struct cut even = cut_for(frame), odd = even;
    pthread_t thread;

    even.every = odd.every = 2;
    odd.first = 1;
    if (pthread_create(&thread, NULL, draw_cut, &odd) != 0)
        return;
    (void)draw_cut(&even);
    (void)pthread_join(thread, NULL);
    CHECK_MSG(!even.failed && !odd.failed, "frame %u: a tile of two threads failed", frame);
    present(frame);
}

/* ---- the suite ---- */

static inline bool open_subject(void)
{
    struct tia_mode now;
    int status = subject.ops->open(subject.ctx, &mode);

    CHECK_MSG(!status, "open: %s", subject.why);
    if (status)
        return false;
    CHECK(mode.width >= 1 && mode.width <= TIA_SIZE_MAX && mode.height >= 1 && mode.height <= TIA_SIZE_MAX);
    CHECK(mode.format && *mode.format);
    CHECK_EQ(subject.ops->mode(subject.ctx, &now), TIA_OK);
    CHECK(now.width == mode.width && now.height == mode.height && now.concurrent == mode.concurrent);
    CHECK(now.tile_width == mode.tile_width && now.tile_height == mode.tile_height);
    return true;
}

static inline void check_refused(unsigned x, unsigned y, unsigned width, unsigned height)
{
    struct tia_tile tile = {(uint16_t)x, (uint16_t)y, (uint16_t)width, (uint16_t)height};
    struct tia_surface surface;
    int status = subject.ops->acquire(subject.ctx, tile, &surface);

    CHECK_MSG(status == TIA_ERR_ARGUMENT, "tile %u,%u %ux%u: status %d", x, y, width, height, status);
}

static inline void check_limits(void)
{
    check_refused(mode.width, 0, 1, 1);
    check_refused(0, mode.height, 1, 1);
    check_refused(0, 0, 0, 1);
    check_refused(0, 0, 1, 0);
    check_refused(mode.width - 1u, 0, 2, 1);
    check_refused(0, mode.height - 1u, 1, 2);
    if (mode.tile_width && mode.tile_width < mode.width)
        check_refused(0, 0, mode.tile_width + 1u, 1);
    if (mode.tile_height && mode.tile_height < mode.height)
        check_refused(0, 0, 1, mode.tile_height + 1u);
}

static inline void conform(void)
{
    subject.ops->close(subject.ctx);
    for (unsigned round = 0; round < 2; round++) {
        subject.last = UINT32_MAX;
        if (!open_subject())
            return;
        for (unsigned frame = 0; frame < 3; frame++)
            one_thread(frame);
        one_thread(2); /* the same frame again */
        if (mode.concurrent)
            two_threads(3);
        check_limits();
        one_thread(4);
        subject.ops->close(subject.ctx);
        subject.ops->close(subject.ctx);
    }
}

#endif
