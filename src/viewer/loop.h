/* loop.h - the state of the interactive loop. */
#ifndef TIA_VIEWER_LOOP_H
#define TIA_VIEWER_LOOP_H

#include <tia/viewer.h>

#define VIEWER_STRIP 16    /* rows of a tile when the display sets no limit */
#define VIEWER_HELD_KEYS 6 /* that are looked at, at a time */

#define VIEWER_PERIOD_US 16666 /* of a display of 60 Hz */
#define VIEWER_PASSES 5        /* coarse to fine: blocks of 16, 8, 4, 2, 1; what comes after are more samples */
#define VIEWER_QUEUE 8         /* events while a frame is drawn; a full queue ends it */

/* Statuses besides tia_status: a key ended the loop; the frame was given up. */
#define VIEWER_QUIT 10
#define VIEWER_OUTDATED 11

/* A key that is held. */
struct held {
    uint64_t due_us; /* when it is next repeated; 0: there is none */
    uint16_t key;
    bool shift;
};

struct loop {
    const struct tia_viewer *viewer;
    const struct tia_core *core;
    const struct tia_scene *base;  /* the viewer's scene, or its copy with another technique for shadows */
    const struct tia_scene *scene; /* base, or *current when it has tracks */
    struct tia_viewer_state state;
    struct tia_camera good; /* the last one that a frame was drawn with */

    /* The display's mode, and what depends on it. */
    struct tia_mode mode;
    struct tia_view *view;
    struct tia_hits *hits;
    size_t view_size, hits_size, simd_size;
    void *hits_memory, *simd_memory;
    int8_t *status;       /* of each tile */
    uint8_t *passes;      /* of each tile, how many are done */
    uint32_t *drawn;      /* of each tile, how many pixels are drawn */
    tia_rgb565 *canvas;   /* the picture so far, see refine.c; NULL: frames are drawn at once */
    struct tia_sum *sums; /* of each pixel, its samples so far; NULL: pixels get all their samples at once */
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
    uint64_t paused_us;        /* since when it is paused */

    /* Where the eye looks, see gaze.c. */
    struct tia_gaze gaze;
    struct tia_acuity acuity;
    bool gazes; /* the acuity says which pixels are drawn */

    /* While a frame is drawn, see watch.c. */
    struct tia_event queue[VIEWER_QUEUE]; /* events that came meanwhile */
    unsigned queued;
    uint64_t lights_us;         /* when its lights were set */
    uint64_t begun_us, look_us; /* when the frame was begun; when to look again */
    bool outdated;              /* a key was pressed since all were handled: while the view was prepared, too */
    bool answered;              /* a picture of this frame has been shown */
    bool gives_up, gave_up;     /* this frame; the one before */
    bool ends;                  /* a key, `stop` or a failed input ends the loop */
    int failure;                /* of the input */

    /* Coarse to fine. */
    bool refining;
    unsigned pass;         /* the one being drawn */
    uint32_t line;         /* what is done of the frame, 2^-16, for the line at the edge; 0: there is none */
    uint64_t show_us;      /* when the pass being drawn is to be shown unfinished */
    uint64_t shown_us;     /* when this frame was last shown or, before that, begun */
    uint64_t showing_us;   /* that it has taken to show it so far */
    uint64_t last_us;      /* that it took to draw the last frame; 0: unknown */
    uint64_t show_cost_us; /* that it took to show a picture */
    bool unfinished;       /* the last frame is one of something that moves, and not as fine as it can be */
    bool complete;         /* the canvas is the whole last frame */

    /* Frames at a given pace, see pace.c. */
    uint32_t cost_ns;                    /* of a pixel, as far as is known; 0: unknown */
    uint32_t pass_pixels[VIEWER_PASSES]; /* drawn in each pass of the last frame */

    uint64_t key_us; /* time of the oldest key press that the next frame will show */
    struct held held[VIEWER_HELD_KEYS];
    struct tia_event last; /* what has ended the loop; its key is 0: no event */
    uint32_t frame;
    bool changed;  /* the screen is out of date */
    bool covered;  /* it is but for what is drawn over the picture */
    bool switched; /* a key has changed the technique since the last frame */
    bool pressed;  /* and one the lights */
    bool showing;  /* the display has not shown all that it was given */
    bool keeps;    /* the viewer's `kept` are those of the last picture, kept_count of them */
    uint32_t kept_count;
};

static inline uint64_t viewer_now(const struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;
    return v->clock ? v->clock->now_us(v->clock_ctx) : 0;
}

/* How many samples pixels have that get them some at a time; else 1. */
static inline uint32_t viewer_spp(const struct loop *loop)
{
    uint32_t spp = loop->base->integration.spp;

    return !loop->sums ? 1 : spp ? spp : TIA_SPP;
}

static inline tia_rgb565 *viewer_canvas_at(const struct loop *loop, unsigned x, unsigned y)
{
    return loop->canvas + (size_t)y * loop->mode.width + x;
}

static inline int viewer_mode(struct loop *loop, struct tia_mode *mode)
{
    int status = loop->viewer->display->mode(loop->viewer->display_ctx, mode);

    loop->showing = loop->showing || status == TIA_BUSY;
    return status == TIA_BUSY ? TIA_OK : status;
}

/* Brings the viewer's state up to date. */
static inline void viewer_tell(struct loop *loop)
{
    struct tia_viewer_state *state = loop->viewer->state;

    loop->state.time = loop->plays ? loop->time : loop->viewer->time;
    if (!state)
        return;
    loop->state.goes_on = state->goes_on;
    *state = loop->state;
}

/* press.c: whether a key sets or moves lights; whether it moves one; whether it changes the technique for shadows. */
bool tia_viewer_lights(const struct loop *loop, const struct tia_event *event);
bool tia_viewer_moves(const struct loop *loop, uint16_t key);
bool tia_viewer_is_switch(const struct loop *loop, uint16_t key);

/* keys.c. tia_viewer_take_events handles all waiting events, VIEWER_QUIT when one quits; tia_viewer_take_quiet, while a
 * frame is drawn, those that leave it as it is and came before all others. */
int tia_viewer_press(struct loop *loop, const struct tia_event *event);
int tia_viewer_take_events(struct loop *loop);
void tia_viewer_take_quiet(struct loop *loop);
int tia_viewer_repeat_held(struct loop *loop);

/* control.c: what an event would do; does what it does beyond lights, VIEWER_QUIT when it quits; goes back to the last
 * camera that could be drawn with, if there is another. */
enum tia_effect tia_viewer_effect(const struct loop *loop, const struct tia_event *event);
int tia_viewer_control(struct loop *loop, const struct tia_event *event);
bool tia_viewer_go_back(struct loop *loop);

/* Adds a pointer's event to the last one that waits; false when they do not go together. */
bool tia_viewer_joins(struct loop *loop, const struct tia_event *event);

/* gaze.c: where the eye looks, after the mode or the gaze has changed; after a pointer's event, true when it looks
 * elsewhere. */
void tia_viewer_gaze(struct loop *loop);
bool tia_viewer_point(struct loop *loop, const struct tia_event *event);

/* fill.c: fills in the pixels that the eye does not need, in the picture so far. */
int tia_viewer_fill(struct loop *loop);

/* When a held key next moves the light; 0: none is held. */
uint64_t tia_viewer_repeat_us(const struct loop *loop);

/* shadows.c: takes the next technique. */
void tia_viewer_switch(struct loop *loop);

/* play.c: sets up the scene at the viewer's start time; brings it up to date before a frame. */
int tia_viewer_play_begin(struct loop *loop);
int tia_viewer_play(struct loop *loop);

/* watch.c: before a frame; while it is drawn, on any thread, TIA_STOPPED or VIEWER_OUTDATED when it is to end; the same
 * as a `stop` callback. */
void tia_viewer_watch_begin(struct loop *loop);
int tia_viewer_watch(struct loop *loop);
bool tia_viewer_stops(void *loop);

/* present.c: the display shows the frame; goes on with what it has not shown yet. While that takes long, keys are
 * looked at, and what they are ends it as it would end drawing: then the rest stays for later. */
int tia_viewer_present(struct loop *loop);
int tia_viewer_go_on(struct loop *loop);

/* prepare.c: memory for the display's mode, and a view of the current scene. */
int tia_viewer_prepare(struct loop *loop);
int tia_viewer_prepare_view(struct loop *loop);

/* tiles.c: drawing a frame. */
int tia_viewer_draw_tiles(struct loop *loop);
struct tia_tile tia_viewer_tile(const struct loop *loop, unsigned index);

/* Runs a job that leaves its status in loop->status for each tile, on the workers if the display lets them. */
int tia_viewer_run_tiles(struct loop *loop, void (*job)(void *loop, unsigned index));
bool tia_viewer_same_mode(const struct tia_mode *a, const struct tia_mode *b);

/* pace.c: the period of `pace`, or that of a display; whether something moves; whether there is time for the pass to
 * come, when something does; takes down what a pass has cost; the time that the whole frame would have taken. */
uint64_t tia_viewer_period_us(const struct loop *loop);
bool tia_viewer_is_moving(const struct loop *loop);
bool tia_viewer_has_time(const struct loop *loop);
void tia_viewer_learn(struct loop *loop, uint32_t pixels, uint64_t us);
uint64_t tia_viewer_whole_us(const struct loop *loop, const struct tia_frame *frame);

/* refine.c: bytes for the picture so far, and for its sums of samples, if any, or 0; takes that memory; whether to draw
 * the next frame coarse to fine; draws it, and sets frame->draw_us. */
uint64_t tia_viewer_canvas_size(const struct loop *loop, bool sums);
void tia_viewer_set_canvas(struct loop *loop, void *memory, uint64_t size);
bool tia_viewer_refines(const struct loop *loop);
int tia_viewer_draw_passes(struct loop *loop, struct tia_frame *frame);

/* pass.c: bytes for sums of samples, or 0; how many passes a complete frame has; the size of a pass's blocks; whether
 * there are rows in their place; the samples of each pixel, and the share of all samples in 2^-16, that are done after
 * so many passes. */
uint64_t tia_viewer_sums_size(const struct loop *loop);
unsigned tia_viewer_passes(const struct loop *loop);
unsigned tia_viewer_block(unsigned pass);
bool tia_viewer_by_rows(const struct loop *loop);
uint32_t tia_viewer_samples(const struct loop *loop, unsigned passes);
uint32_t tia_viewer_share(const struct loop *loop, unsigned passes);

/* Draws what loop->pass adds to a tile; *drawn counts the pixels that had none of their samples before. */
int tia_viewer_refine_tile(struct loop *loop, struct tia_tile tile, uint32_t *drawn);

/* The picture so far onto the display; after the loop, if it has been shown and the display is still the same. */
int tia_viewer_copy(struct loop *loop);
void tia_viewer_copy_last(struct loop *loop);

#endif
