/* loop.h - the state of the interactive loop. */
#ifndef TIA_VIEWER_LOOP_H
#define TIA_VIEWER_LOOP_H

#include <tia/viewer.h>

#define VIEWER_STRIP 16 /* rows of a tile when the display sets no limit */
#define VIEWER_HELD_KEYS (TIA_KEY_PAGE_DOWN - TIA_KEY_LEFT + 1)

#define VIEWER_PASSES 5 /* coarse to fine: blocks of 16, 8, 4, 2, 1 */
#define VIEWER_QUEUE 8  /* events while a frame is drawn; a full queue ends it */

/* Statuses besides tia_status: a key ended the loop; the frame was given up. */
#define VIEWER_QUIT 10
#define VIEWER_OUTDATED 11

struct loop {
    const struct tia_viewer *viewer;
    const struct tia_core *core;
    const struct tia_scene *base;  /* the viewer's scene, or its copy with another technique for shadows */
    const struct tia_scene *scene; /* base, or *current when it has tracks */
    uint32_t light_count;

    /* The display's mode, and what depends on it. */
    struct tia_mode mode;
    struct tia_view *view;
    struct tia_hits *hits;
    size_t view_size, hits_size, level_size;
    void *hits_memory, *level_memory;
    int8_t *status;     /* of each tile */
    uint8_t *passes;    /* of each tile, how many are done */
    tia_rgb565 *canvas; /* the picture so far, see refine.c; NULL: frames are drawn at once */
    unsigned tile_width, tile_height, columns;
    uint32_t tiles;
    bool view_ready; /* the view is up to date, except perhaps for its lights */
    bool whole;      /* there is memory for the whole frame's hits */
    unsigned traced; /* the passes whose hits are valid; VIEWER_PASSES: all are, relight instead of tracing */

    /* Animation. */
    struct tia_scene *current; /* the scene at `time`, followed by the arrays that it points to */
    void *bvh_memory;
    size_t current_size, bvh_size;
    tia_q16 time, end; /* of *current, and of the last keyframe; seconds */
    bool plays, started;
    bool only_lights;          /* nothing but lights moves: hits stay valid */
    uint64_t start_us, due_us; /* when playing began; when the next frame is due */

    /* While a frame is drawn, see watch.c. */
    struct tia_event queue[VIEWER_QUEUE]; /* events that came meanwhile */
    unsigned queued;
    uint64_t begun_us, look_us; /* when the frame was begun; when to look again */
    bool outdated;              /* a key was pressed since the frame was begun */
    bool answered;              /* a picture of this frame has been shown */
    bool gives_up, gave_up;     /* this frame; the one before */
    bool ends;                  /* a key, `stop` or a failed input ends the loop */
    int failure;                /* of the input */

    /* Coarse to fine. */
    bool refining;
    unsigned pass;       /* the one being drawn */
    uint32_t line;       /* what is done of the frame, 2^-16, for the line at the edge; 0: there is none */
    uint64_t show_us;    /* when the pass being drawn is to be shown unfinished */
    uint64_t shown_us;   /* when this frame was last shown or, before that, begun */
    uint64_t showing_us; /* that it has taken to show it so far */
    uint64_t last_us;    /* that it took to draw the last frame; 0: unknown */

    uint64_t key_us;                      /* time of the oldest key press that the next frame will show */
    uint64_t repeat_us[VIEWER_HELD_KEYS]; /* when a held key next moves the light; 0: not held */
    uint32_t frame;
    bool changed;  /* the screen is out of date */
    bool switched; /* a key has changed the technique since the last frame */
};

static inline uint64_t viewer_now(const struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;
    return v->clock ? v->clock->now_us(v->clock_ctx) : 0;
}

/* press.c: whether a key ends the loop; whether it changes the technique for shadows. */
bool tia_viewer_quits(const struct loop *loop, uint16_t key);
bool tia_viewer_is_switch(const struct loop *loop, uint16_t key);

/* keys.c. tia_viewer_take_events handles all waiting events. VIEWER_QUIT when a key quits. */
int tia_viewer_press(struct loop *loop, uint16_t key);
int tia_viewer_take_events(struct loop *loop);
void tia_viewer_repeat_held(struct loop *loop);

/* When a held key next moves the light; 0: none is held. */
uint64_t tia_viewer_repeat_us(const struct loop *loop);

/* shadows.c: takes the next technique. */
void tia_viewer_switch(struct loop *loop);

/* play.c: sets up the scene at the viewer's start time; brings it up to date before a frame. */
int tia_viewer_play_begin(struct loop *loop);
int tia_viewer_play(struct loop *loop);

/* watch.c: before a frame; while it is drawn, on any thread, TIA_STOPPED or VIEWER_OUTDATED when it is to end; the
 * same for whoever asks whether to stop. */
void tia_viewer_watch_begin(struct loop *loop);
int tia_viewer_watch(struct loop *loop);
bool tia_viewer_stops(void *loop);

/* prepare.c: memory for the display's mode, and a view of the current scene. */
int tia_viewer_prepare(struct loop *loop);
int tia_viewer_prepare_view(struct loop *loop);

/* tiles.c: drawing a frame. */
int tia_viewer_draw_tiles(struct loop *loop);
struct tia_tile tia_viewer_tile(const struct loop *loop, unsigned index);

/* Runs a job that leaves its status in loop->status for each tile, on the workers if the display lets them. */
int tia_viewer_run_tiles(struct loop *loop, void (*job)(void *loop, unsigned index));
bool tia_viewer_same_mode(const struct tia_mode *a, const struct tia_mode *b);

/* refine.c: bytes for the picture so far, or 0; whether to draw the next frame coarse to fine; draws it, and sets
 * frame->draw_us. */
uint64_t tia_viewer_canvas_size(const struct loop *loop);
bool tia_viewer_refines(const struct loop *loop);
int tia_viewer_draw_passes(struct loop *loop, struct tia_frame *frame);

#endif
