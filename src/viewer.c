/* viewer.c - the interactive loop: keys, light, tiles, present. Knows no OS. */
#include <tia/viewer.h>

#define STRIP 16 /* rows of a tile where the display sets no limit */
#define HELD_KEYS (TIA_KEY_PAGE_DOWN - TIA_KEY_LEFT + 1)
#define ALIGN(size) (((size) + 7) & ~(size_t)7)

/* What must end the loop besides an error: a quitting key. */
#define QUIT 2

struct loop {
    const struct tia_viewer *viewer;
    const struct tia_core *core;
    uint32_t light_count;

    /* The display's mode and what was made for it. */
    struct tia_mode mode;
    struct tia_view *view;
    struct tia_hits *hits;
    void *hits_memory;
    size_t hits_size;
    int8_t *status; /* of each tile */
    unsigned tile_width, tile_height, columns, tiles;
    bool whole;  /* the hits of the whole frame fit */
    bool traced; /* and are valid */

    bool changed; /* the screen does not show the lights as they are */
    uint32_t frame;
    uint64_t key_us;               /* the oldest key that the next frame will show */
    uint64_t repeat_us[HELD_KEYS]; /* when a held key moves the light again; 0: not held */
};

static uint64_t now(const struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;
    return v->clock ? v->clock->now_us(v->clock_ctx) : 0;
}

static int press(struct loop *loop, uint16_t key)
{
    const struct tia_viewer *v = loop->viewer;
    int status = tia_press(v->scene, v->lights, &loop->light_count, v->light_capacity, key);

    if (status < 0)
        return QUIT;
    loop->changed = loop->changed || status > 0;
    return TIA_OK;
}

static bool is_held_key(uint16_t key)
{
    return key >= TIA_KEY_LEFT && key <= TIA_KEY_PAGE_DOWN;
}

static int take_event(struct loop *loop, const struct tia_event *event)
{
    uint64_t *repeat = is_held_key(event->key) ? &loop->repeat_us[event->key - TIA_KEY_LEFT] : NULL;

    if (event->kind == TIA_EVENT_RELEASE) {
        if (repeat)
            *repeat = 0;
        return TIA_OK;
    }
    if (repeat && event->kind == TIA_EVENT_PRESS && loop->viewer->clock)
        *repeat = now(loop) + TIA_HOLD_DELAY_US;
    if (event->time_us && (!loop->key_us || event->time_us < loop->key_us))
        loop->key_us = event->time_us;
    return press(loop, event->key);
}

/* All that waits is taken before a frame is drawn. */
static int take_events(struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;
    struct tia_event event;
    int status = 0;

    while (v->input && (status = v->input->poll(v->input_ctx, &event)) > 0) {
        status = take_event(loop, &event);
        if (status)
            return status;
    }
    return status;
}

/* Moves the light for held keys whose time has come. After a pause that long that a person would
 * see a jump, steps that were missed are dropped. */
static void repeat_held(struct loop *loop)
{
    uint64_t time = now(loop);

    for (uint16_t i = 0; i < HELD_KEYS; i++) {
        uint64_t *repeat = &loop->repeat_us[i];
        if (*repeat && time > *repeat + 1000000)
            *repeat = time;
        for (; *repeat && time >= *repeat; *repeat += TIA_HOLD_STEP_US)
            press(loop, (uint16_t)(TIA_KEY_LEFT + i));
    }
}

/* How long nothing will happen, in ms, rounded up; -1: until a key. */
static int idle_ms(const struct loop *loop)
{
    uint64_t time = now(loop), next = 0;

    for (unsigned i = 0; i < HELD_KEYS; i++)
        if (loop->repeat_us[i] && (!next || loop->repeat_us[i] < next))
            next = loop->repeat_us[i];
    if (!next)
        return -1;
    return next > time ? (int)((next - time + 999) / 1000) : 0;
}

static void lay_tiles(struct loop *loop, unsigned height)
{
    const struct tia_mode *m = &loop->mode;

    loop->tile_width = m->tile_width && m->tile_width < m->width ? m->tile_width : m->width;
    loop->tile_height = m->tile_height && m->tile_height < height ? m->tile_height : height;
    loop->columns = (m->width + loop->tile_width - 1) / loop->tile_width;
    loop->tiles = loop->columns * ((m->height + loop->tile_height - 1) / loop->tile_height);
}

/* Asks the caller for memory: view, a status for each tile, hits. */
static bool take_memory(struct loop *loop, struct tia_tile hits)
{
    const struct tia_viewer *v = loop->viewer;
    size_t view = loop->core->view_size(v->scene, v->light_capacity), status = ALIGN(loop->tiles);
    size_t size = loop->core->hits_size(hits);
    char *memory = NULL;

    if (view < SIZE_MAX / 4 && size < SIZE_MAX / 4) {
        view = ALIGN(view);
        memory = v->memory(v->memory_ctx, view + status + size);
    }
    if (!memory)
        return false;
    loop->view = (struct tia_view *)(void *)memory;
    loop->status = (int8_t *)(memory + view);
    loop->hits_memory = memory + view + status;
    loop->hits_size = size;
    return true;
}

/* Room for the whole frame's hits, or for those of one tile, as many rows of it as fit. */
static bool find_memory(struct loop *loop)
{
    struct tia_tile frame = {0, 0, loop->mode.width, loop->mode.height};

    lay_tiles(loop, STRIP);
    loop->whole = take_memory(loop, frame);
    if (loop->whole)
        return true;
    for (unsigned rows = STRIP; rows > 0; rows /= 2) {
        lay_tiles(loop, rows);
        struct tia_tile tile = {0, 0, (uint16_t)loop->tile_width, (uint16_t)loop->tile_height};
        if (take_memory(loop, tile))
            return true;
    }
    return false;
}

static int prepare(struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;
    struct tia_tile frame = {0, 0, loop->mode.width, loop->mode.height};
    int status;

    if (!find_memory(loop))
        return TIA_ERR_MEMORY;
    status = loop->core->view_init(&loop->view, loop->view, loop->core->view_size(v->scene, v->light_capacity),
                                   v->scene, v->light_capacity, loop->mode.width, loop->mode.height);
    if (!status && loop->whole)
        status = loop->core->hits_init(&loop->hits, loop->hits_memory, loop->hits_size, frame);
    loop->traced = false;
    loop->changed = true;
    return status;
}

static struct tia_tile tile_at(const struct loop *loop, unsigned index)
{
    unsigned x = index % loop->columns * loop->tile_width, y = index / loop->columns * loop->tile_height;
    unsigned width = loop->mode.width - x, height = loop->mode.height - y;
    struct tia_tile tile = {(uint16_t)x, (uint16_t)y, (uint16_t)(width < loop->tile_width ? width : loop->tile_width),
                            (uint16_t)(height < loop->tile_height ? height : loop->tile_height)};

    return tile;
}

static int draw_tile(struct loop *loop, struct tia_tile tile)
{
    const struct tia_viewer *v = loop->viewer;
    struct tia_hits *hits = loop->hits;
    struct tia_surface surface;
    int status = TIA_OK;

    if (!loop->whole)
        status = loop->core->hits_init(&hits, loop->hits_memory, loop->hits_size, tile);
    if (!status && !loop->traced)
        status = loop->core->trace(loop->view, hits, tile);
    if (!status)
        status = v->display->acquire(v->display_ctx, tile, &surface);
    if (!status)
        status = loop->core->light(loop->view, hits, tile, &surface, &v->options);
    return status ? status : v->display->submit(v->display_ctx, tile);
}

static void tile_job(void *arg, unsigned index)
{
    struct loop *loop = arg;
    loop->status[index] = (int8_t)draw_tile(loop, tile_at(loop, index));
}

static int draw_tiles(struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;
    int status = TIA_OK;

    if (v->workers && loop->mode.concurrent && loop->whole) {
        v->workers->run(v->workers_ctx, tile_job, loop, loop->tiles);
        for (unsigned i = 0; !status && i < loop->tiles; i++)
            status = loop->status[i];
    } else {
        for (unsigned i = 0; !status && i < loop->tiles; i++)
            status = draw_tile(loop, tile_at(loop, i));
    }
    return status;
}

static int draw_frame(struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;
    struct tia_frame frame = {.number = loop->frame, .relit = loop->traced};
    uint64_t start = now(loop), key_us = loop->key_us;
    int status = loop->core->set_lights(loop->view, v->lights, loop->light_count);

    if (!status)
        status = draw_tiles(loop);
    frame.draw_us = now(loop) - start;
    if (!status)
        status = v->display->present(v->display_ctx);
    if (status)
        return status;
    loop->traced = loop->whole;
    loop->changed = false;
    loop->key_us = 0;
    loop->frame++;
    frame.key_us = key_us && v->clock ? now(loop) - key_us : 0;
    return v->frame_done ? v->frame_done(v->frame_ctx, &frame) : TIA_OK;
}

static bool same_mode(const struct tia_mode *a, const struct tia_mode *b)
{
    return a->width == b->width && a->height == b->height && a->tile_width == b->tile_width &&
           a->tile_height == b->tile_height && a->concurrent == b->concurrent;
}

/* Draws what the display now needs. TIA_HIDDEN when it is not ours. */
static int show(struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;
    struct tia_mode mode;
    int status = v->display->mode(v->display_ctx, &mode);

    if (status == TIA_HIDDEN)
        loop->changed = true;
    if (!status && (!loop->view || !same_mode(&mode, &loop->mode))) {
        loop->mode = mode;
        status = prepare(loop);
    }
    if (!status && (loop->changed || v->frame_limit))
        status = draw_frame(loop);
    return status;
}

/* Sleeps until something can happen; with frames still to draw it only lets signals in. */
static int rest(struct loop *loop, bool hidden)
{
    const struct tia_viewer *v = loop->viewer;
    bool busy = !hidden && (loop->changed || v->frame_limit);

    if (!v->input)
        return hidden ? TIA_HIDDEN : TIA_OK;
    return v->input->wait(v->input_ctx, busy ? 0 : hidden ? -1 : idle_ms(loop));
}

static int step(struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;
    int status = take_events(loop);

    if (status)
        return status;
    repeat_held(loop);
    status = show(loop);
    if (status && status != TIA_HIDDEN)
        return status;
    if (v->frame_limit && loop->frame >= v->frame_limit)
        return QUIT;
    if (v->stop && *v->stop) /* a display that had to wait has let signals in */
        return QUIT;
    return rest(loop, status == TIA_HIDDEN);
}

int tia_viewer_run(struct tia_viewer *viewer)
{
    struct loop loop = {.viewer = viewer, .core = viewer->core ? viewer->core : &tia_core_q16, .changed = true};
    const struct tia_scene *scene = viewer->scene;
    int status = TIA_OK;

    if (viewer->light_capacity < scene->light_count || (!viewer->input && !viewer->frame_limit) ||
        viewer->options.reached)
        return TIA_ERR_ARGUMENT;
    for (uint32_t i = 0; i < scene->light_count; i++)
        viewer->lights[i] = scene->lights[i];
    loop.light_count = scene->light_count;
    for (size_t i = 0; !status && i < viewer->key_count; i++)
        status = press(&loop, viewer->keys[i]);
    while (!status && !(viewer->stop && *viewer->stop))
        status = step(&loop);
    return status == QUIT ? TIA_OK : status;
}
