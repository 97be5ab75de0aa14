/* viewer_world.h - a simulated world for tia_viewer_run: a display, an input, a clock and memory that follow a script
 * and check the calls. Time passes only while the viewer waits, draws or shows; every frame is compared with a full
 * render when it is presented. */
#ifndef TESTS_VIEWER_WORLD_H
#define TESTS_VIEWER_WORLD_H

#include <tia/viewer.h>

#include "check.h"

enum { WORLD_WIDTH = 64, WORLD_HEIGHT = 48, WORLD_EVENTS = 200, WORLD_FRAMES = 400, WORLD_LIGHTS = 3 };

enum world_call { CALL_NONE, CALL_MODE, CALL_ACQUIRE, CALL_SUBMIT, CALL_PRESENT, CALL_POLL, CALL_WAIT };

struct world_event {
    uint64_t at_us;
    struct tia_event event;
};

struct world_frame {
    uint64_t drawn_us;     /* time when the frame's first tile was begun */
    struct tia_vec3 light; /* the first light's position */
    struct tia_frame told;
};

struct world {
    struct tia_viewer viewer;
    struct tia_workers workers; /* workers, for tests that have several jobs */
    struct tia_light lights[WORLD_LIGHTS];
    struct tia_light kept[WORLD_LIGHTS];
    bool detached[WORLD_LIGHTS];
    uint64_t now_us;

    /* NULL, or returns the scene that the frame just drawn must show */
    const struct tia_scene *(*scene_now)(const struct world *);

    /* NULL, or compares a picture that is not always a full render; `full` has WORLD_WIDTH pixels a row */
    void (*compare)(struct world *, const tia_rgb565 *full);

    /* The script. */
    struct world_event events[WORLD_EVENTS]; /* events in the order of time */
    unsigned event_count;
    struct tia_mode mode, later_mode; /* later_mode: the mode after change_after frames, if not 0 */
    unsigned change_after;
    uint64_t hidden_from_us, hidden_until_us;
    uint64_t tile_us, present_us; /* time for drawing a tile, and for presenting */
    unsigned slices;              /* number of calls of go_on, of 20 ms each, that a frame needs */
    uint64_t again_us;            /* if not 0: the time from which `mode` once requests that the last frame is shown
                                     again */
    enum world_call fail;         /* call that fails, after fail_after frames */
    unsigned fail_after, stop_after;
    uint64_t fail_from_us;
    int done_status; /* result of frame_done */
    size_t memory_limit;

    /* The record. */
    unsigned slices_left, slices_done;
    unsigned next_event, tiles, acquired, memory_calls, runs, frame_count;
    size_t memory_size;
    int stop, entered;
    struct world_frame frames[WORLD_FRAMES];
    tia_rgb565 pixels[WORLD_WIDTH * WORLD_HEIGHT];
};

static uint64_t world_memory[65536], world_reference[65536];

static inline int world_result(const struct world *w, enum world_call call)
{
    return w->fail == call && w->frame_count >= w->fail_after && w->now_us >= w->fail_from_us ? TIA_ERR_DEVICE : TIA_OK;
}

static inline bool world_hidden(const struct world *w)
{
    return w->now_us >= w->hidden_from_us && w->now_us < w->hidden_until_us;
}

static inline bool world_event_waits(const struct world *w)
{
    return w->next_event < w->event_count && w->events[w->next_event].at_us <= w->now_us;
}

static inline uint64_t world_now(void *ctx)
{
    return ((struct world *)ctx)->now_us;
}

/* ---- the display ---- */

static inline const struct tia_mode *world_mode_now(const struct world *w)
{
    return w->change_after && w->frame_count >= w->change_after ? &w->later_mode : &w->mode;
}

static inline int world_mode(void *ctx, struct tia_mode *mode)
{
    struct world *w = ctx;

    *mode = *world_mode_now(w);
    if (w->again_us && w->now_us >= w->again_us) {
        w->again_us = 0;
        w->slices_left = w->slices;
        return TIA_BUSY;
    }
    return world_hidden(w) ? TIA_HIDDEN : world_result(w, CALL_MODE);
}

static inline int world_acquire(void *ctx, struct tia_tile tile, struct tia_surface *surface)
{
    struct world *w = ctx;
    const struct tia_mode *mode = world_mode_now(w);

    CHECK(!world_hidden(w) && w->acquired == 0);
    CHECK(w->tiles > 0 || w->compare || !world_event_waits(w)); /* all keys are handled before a frame is begun */
    CHECK(!mode->tile_width || tile.width <= mode->tile_width);
    CHECK(!mode->tile_height || tile.height <= mode->tile_height);
    if (world_result(w, CALL_ACQUIRE))
        return TIA_ERR_DEVICE;
    if (!w->tiles++ && w->frame_count < WORLD_FRAMES)
        w->frames[w->frame_count].drawn_us = w->now_us;
    w->acquired++;
    w->now_us += w->tile_us;
    *surface =
        (struct tia_surface){.pixels = w->pixels + tile.y * WORLD_WIDTH + tile.x, .step = 2, .pitch = 2 * WORLD_WIDTH};
    return TIA_OK;
}

static inline int world_submit(void *ctx, struct tia_tile tile)
{
    struct world *w = ctx;

    (void)tile;
    CHECK_EQ(w->acquired, 1);
    w->acquired--;
    return world_result(w, CALL_SUBMIT);
}

/* Compares the picture with one that is traced as a whole, with the present lights. */
static inline void world_compare(struct world *w)
{
    static tia_rgb565 want[WORLD_WIDTH * WORLD_HEIGHT];
    const struct tia_mode *mode = world_mode_now(w);
    struct tia_tile all = {0, 0, mode->width, mode->height};
    struct tia_surface surface = {.pixels = want, .step = 2, .pitch = 2 * WORLD_WIDTH};
    size_t half = sizeof world_reference / 2;
    struct tia_view *view = NULL;
    struct tia_hits *hits = NULL;
    uint32_t lights = 0;
    const struct tia_scene *scene = w->scene_now ? w->scene_now(w) : w->viewer.scene;

    while (lights < WORLD_LIGHTS && w->lights[lights].radius)
        lights++;
    CHECK_EQ(tia_view_init(&view, world_reference, half, scene, WORLD_LIGHTS, all.width, all.height, NULL), TIA_OK);
    CHECK_EQ(tia_view_set_lights(view, w->lights, lights), TIA_OK);
    CHECK_EQ(tia_hits_init(&hits, (char *)world_reference + half, half, view, all), TIA_OK);
    CHECK_EQ(tia_view_draw(view, hits, all, &surface, &(struct tia_options){.dither = w->viewer.dither}), TIA_OK);
    if (w->compare)
        w->compare(w, want);
    for (unsigned y = 0; y < all.height && !w->compare; y++)
        CHECK_MSG(!memcmp(w->pixels + y * WORLD_WIDTH, want + y * WORLD_WIDTH, 2u * all.width), "frame %u, row %u",
                  w->frame_count, y);
}

static inline int world_present(void *ctx)
{
    struct world *w = ctx;

    CHECK(!world_hidden(w) && w->acquired == 0);
    world_compare(w);
    memset(w->pixels, 0x5a, sizeof w->pixels);
    w->tiles = 0;
    w->now_us += w->present_us;
    w->slices_left += w->slices;
    return w->slices_left ? TIA_BUSY : world_result(w, CALL_PRESENT);
}

static inline int world_go_on(void *ctx)
{
    struct world *w = ctx;

    CHECK(w->slices_left > 0);
    w->now_us += 20000;
    w->slices_left--;
    w->slices_done++;
    return w->slices_left ? TIA_BUSY : world_result(w, CALL_PRESENT);
}

static const struct tia_display world_display = {.mode = world_mode,
                                                 .acquire = world_acquire,
                                                 .submit = world_submit,
                                                 .present = world_present,
                                                 .go_on = world_go_on};

/* ---- the input ---- */

static inline int world_poll(void *ctx, struct tia_event *event)
{
    struct world *w = ctx;

    if (world_result(w, CALL_POLL) || !world_event_waits(w))
        return world_result(w, CALL_POLL);
    *event = w->events[w->next_event++].event;
    return 1;
}

/* Sleeps until the next event of the script. A sleep without an end is an error. */
static inline int world_wait(void *ctx, int timeout_ms)
{
    struct world *w = ctx;
    uint64_t until = timeout_ms < 0 ? UINT64_MAX : w->now_us + (uint64_t)timeout_ms * 1000;

    if (w->next_event < w->event_count && w->events[w->next_event].at_us < until)
        until = w->events[w->next_event].at_us;
    if (w->hidden_until_us > w->now_us) {
        uint64_t switched = world_hidden(w) ? w->hidden_until_us : w->hidden_from_us;
        until = switched < until ? switched : until;
    }
    CHECK_MSG(until != UINT64_MAX, "it would sleep forever");
    if (until == UINT64_MAX)
        return TIA_ERR_UNSUPPORTED;
    w->now_us = until > w->now_us ? until : w->now_us;
    return world_result(w, CALL_WAIT);
}

static const struct tia_input world_input = {.poll = world_poll, .wait = world_wait};

static inline void world_event(struct world *w, uint64_t at_us, enum tia_event_kind kind, uint16_t key)
{
    w->events[w->event_count++] = (struct world_event){at_us, {.kind = kind, .key = key, .time_us = at_us}};
}

/* ---- the clock, memory and workers ---- */

static const struct tia_clock world_clock = {.now_us = world_now};

static inline void *world_take_memory(void *ctx, size_t size)
{
    struct world *w = ctx;

    w->memory_calls++;
    CHECK(size > 0);
    if (size > w->memory_limit || size > sizeof world_memory)
        return NULL;
    w->memory_size = size;
    memset(world_memory, 0xa5, sizeof world_memory);
    return world_memory;
}

/* Runs the jobs in reverse order: the order must not matter. */
static inline void world_run(void *ctx, void (*job)(void *arg, unsigned index), void *arg, unsigned count)
{
    ((struct world *)ctx)->runs++;
    while (count-- > 0)
        job(arg, count);
}

static inline bool world_enter(void *ctx)
{
    return !((struct world *)ctx)->entered++;
}

static inline void world_leave(void *ctx)
{
    ((struct world *)ctx)->entered--;
}

static inline bool world_stop(void *ctx)
{
    return ((struct world *)ctx)->stop;
}

static inline int world_frame_done(void *ctx, const struct tia_frame *frame)
{
    struct world *w = ctx;

    CHECK_EQ(frame->number, w->frame_count);
    if (w->frame_count < WORLD_FRAMES) {
        w->frames[w->frame_count].light = w->lights[0].centre;
        w->frames[w->frame_count].told = *frame;
    }
    w->frame_count++;
    w->stop = w->stop_after && w->frame_count >= w->stop_after;
    return w->done_status;
}

/* Returns the thesis scene on a display of 64x48, with all parts set and no events. */
static inline struct world *world_new(void)
{
    static struct world w;

    w = (struct world){.now_us = 1000000, .memory_limit = SIZE_MAX};
    w.workers = (struct tia_workers){world_run, world_enter, world_leave, &w, 1};
    w.mode = (struct tia_mode){.width = WORLD_WIDTH, .height = WORLD_HEIGHT, .format = "RGB565"};
    w.viewer = (struct tia_viewer){
        .scene = &tia_thesis_scene,
        .lights = {.array = w.lights, .kept = w.kept, .detached = w.detached, .capacity = WORLD_LIGHTS},
        .ports = {.display = &world_display,
                  .display_ctx = &w,
                  .input = &world_input,
                  .input_ctx = &w,
                  .clock = &world_clock,
                  .clock_ctx = &w},
        .hooks = {.memory = world_take_memory, .frame_done = world_frame_done, .ctx = &w},
        .job = {.stop = world_stop, .ctx = &w},
    };
    return &w;
}

/* Runs the viewer and checks that no byte was written beyond the memory that it requested. */
static inline int world_play(struct world *w)
{
    int status = tia_viewer_run(&w->viewer);
    const unsigned char *end = (const unsigned char *)world_memory + sizeof world_memory;

    for (const unsigned char *p = (const unsigned char *)world_memory + w->memory_size; w->memory_size && p < end; p++)
        CHECK_EQ(*p, 0xa5);
    return status;
}

/* ---- scripts ---- */

#define START 1000000 /* the clock's time when a world begins */
#define ONE TIA_Q16_ONE

static const uint16_t key_a[] = {'a'};

/* Returns a world with the light of key a, at (-20, 20, -20). */
static inline struct world *lit_world(void)
{
    struct world *w = world_new();

    w->viewer.keys = key_a;
    w->viewer.key_count = 1;
    return w;
}

static inline void quit_at(struct world *w, uint64_t at_us)
{
    world_event(w, at_us, TIA_EVENT_TAP, 'q');
}

#endif
