/* loop.h - the state of the interactive loop, and its parts. */
#ifndef TIA_VIEWER_LOOP_H
#define TIA_VIEWER_LOOP_H

#include <tia/viewer.h>

#define VIEWER_STRIP 16 /* rows of a tile where the display sets no limit */
#define VIEWER_HELD_KEYS (TIA_KEY_PAGE_DOWN - TIA_KEY_LEFT + 1)

/* What must end the loop besides an error: a quitting key. */
#define VIEWER_QUIT 2

struct loop {
    const struct tia_viewer *viewer;
    const struct tia_core *core;
    const struct tia_scene *scene; /* as it is now: the viewer's, or *moment */
    uint32_t light_count;

    /* The display's mode and what was made for it. */
    struct tia_mode mode;
    struct tia_view *view;
    struct tia_hits *hits;
    size_t view_size, hits_size;
    void *hits_memory;
    int8_t *status; /* of each tile */
    unsigned tile_width, tile_height, columns, tiles;
    bool view_ready; /* the view is of the scene as it is, but for its lights */
    bool whole;      /* the hits of the whole frame fit */
    bool traced;     /* and are valid */

    /* A scene that moves. */
    bool plays;
    bool only_lights;         /* nothing but lights moves: hits stay valid */
    struct tia_scene *moment; /* the scene at `time`, in front of what it points to */
    void *boxes_memory;
    size_t moment_size, boxes_size;
    tia_q16 time, end; /* now, and of the last keyframe */
    bool started;
    uint64_t start_us, due_us; /* when playing began; when the next frame is due */

    bool changed; /* the screen does not show the lights as they are */
    uint32_t frame;
    uint64_t key_us;                      /* the oldest key that the next frame will show */
    uint64_t repeat_us[VIEWER_HELD_KEYS]; /* when a held key moves the light again; 0: not held */
};

static inline uint64_t viewer_now(const struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;
    return v->clock ? v->clock->now_us(v->clock_ctx) : 0;
}

/* keys.c: all that waits is taken before a frame is drawn. VIEWER_QUIT after a quitting key. */
int tia_viewer_press(struct loop *loop, uint16_t key);
int tia_viewer_take_events(struct loop *loop);
void tia_viewer_repeat_held(struct loop *loop);

/* When a held key moves the light next; 0: none is held. */
uint64_t tia_viewer_repeat_us(const struct loop *loop);

/* play.c: the scene as it is at its first moment; and before a frame, as it is now. */
int tia_viewer_play_begin(struct loop *loop);
int tia_viewer_play(struct loop *loop);

/* tiles.c: memory and a view for the display's mode and the scene as it is; all tiles of a frame. */
int tia_viewer_prepare(struct loop *loop);
int tia_viewer_prepare_view(struct loop *loop);
int tia_viewer_draw_tiles(struct loop *loop);

#endif
