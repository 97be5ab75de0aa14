/* loop.h - the state of the interactive loop. */
#ifndef TIA_VIEWER_LOOP_H
#define TIA_VIEWER_LOOP_H

#include <tia/simd.h>
#include <tia/viewer.h>

#include "acuity.h"
#include "scene/cancel.h"

#define VIEWER_STRIP 16    /* least number of rows of a tile when the display sets no limit */
#define VIEWER_HELD_KEYS 6 /* largest number of held keys that repeat at the same time */

#define VIEWER_PERIOD_US 16666 /* period of a display of 60 Hz */
#define VIEWER_PASSES 5        /* number of passes of blocks, of 16, 8, 4, 2 and 1 pixels; later passes add samples */
#define VIEWER_FIRST_BLOCK (1u << (VIEWER_PASSES - 1)) /* size of the blocks of the first pass */
#define VIEWER_QUEUE 8 /* largest number of events queued while a frame is drawn; a full queue ends the frame */

/* Statuses besides tia_status. */
#define VIEWER_QUIT 10     /* a key ended the loop */
#define VIEWER_OUTDATED 11 /* the frame was given up: it is out of date */

/* A key that is held. */
struct held {
    uint64_t due_us; /* time of its next repeat; 0: the entry is free */
    uint16_t key;
    bool shift;
};

struct loop;

/* A function that checks a scene, with the result of tia_check_scene. */
typedef int scene_check(const struct tia_scene *scene, struct tia_fault *fault, struct cancel *cancel);

/* Functions that only tia_viewer_run needs. As they are called through this table, the linker drops them from a program
 * that calls only tia_viewer_run_spheres. */
struct viewer_more {
    scene_check *check;
    int (*play_begin)(struct loop *loop);
    int (*play)(struct loop *loop);
    bool (*is_moving)(const struct loop *loop);
    void (*gaze)(struct loop *loop);
    unsigned (*strip_rows)(const struct loop *loop);
    uint64_t (*canvas_size)(const struct loop *loop, bool sums);
    void (*set_canvas)(struct loop *loop, void *memory, uint64_t size);
    bool (*refines)(const struct loop *loop);
    int (*draw_passes)(struct loop *loop, struct tia_frame *frame);
    uint64_t (*whole_us)(const struct loop *loop, const struct tia_frame *frame);
    int (*copy)(struct loop *loop);
    void (*copy_last)(struct loop *loop);
    enum tia_effect (*effect)(const struct loop *loop, const struct tia_event *event);
    int (*control)(struct loop *loop, const struct tia_event *event);
    bool (*go_back)(struct loop *loop);
    bool (*joins)(struct loop *loop, const struct tia_event *event);
    void (*switch_shadows)(struct loop *loop);
};

/* What a coarse frame has drawn of a tile. */
struct tile_work {
    uint64_t us;       /* time spent on it, microseconds */
    uint64_t alone_us; /* time before the last pass of blocks */
    uint64_t drawn;    /* number of pixels drawn; 64 bits, so that the size is the same on all machines */
};

struct loop {
    const struct tia_viewer *viewer;
    const struct viewer_more *more; /* NULL: spheres alone */
    const struct tia_core *core;
    const struct tia_scene *base;  /* the viewer's scene, or its copy with another technique for shadows */
    const struct tia_scene *scene; /* base or, if the scene plays, *current */
    struct tia_viewer_state state;
    struct tia_camera good; /* camera of the last frame that was drawn */

    /* The display's mode, and data that depend on the mode. */
    struct tia_mode mode;
    struct tia_view *view;
    struct tia_hits *hits;
    size_t view_size, hits_size, simd_size;
    void *hits_memory, *simd_memory;
    int8_t *status;         /* status of each tile */
    uint8_t *passes;        /* number of passes done in each tile */
    struct tile_work *work; /* of each tile of frames that are drawn coarse to fine */
    tia_rgb565 *canvas;     /* the picture so far, see refine.c; NULL: frames are drawn at once */
    struct tia_sum *sums;   /* each pixel's samples so far; NULL: pixels get all their samples at once */
    unsigned tile_width, tile_height, columns;
    uint32_t tiles;
    bool view_ready; /* the view is up to date, except perhaps for its lights */
    uint32_t step;   /* from one tile to the next in the order of a coarse frame */
    bool whole;      /* there is memory for the whole frame's hits */
    unsigned traced; /* number of passes whose hits are valid; VIEWER_PASSES: all hits are, so the frame is lit without
                        tracing */

    /* Animation. */
    struct tia_scene *current; /* the scene at `time`, followed by the arrays that it points to */
    void *bvh_memory;
    size_t current_size, bvh_size;
    tia_q16 time, end; /* time of *current, and of the last keyframe; seconds */
    bool plays, started;
    bool only_lights;          /* only lights move: hits stay valid */
    uint64_t start_us, due_us; /* start of playing; time of the next frame */
    uint64_t paused_us;        /* start of the pause */

    /* The gaze, see gaze.c. */
    struct tia_gaze gaze;
    struct tia_acuity acuity;
    bool gazes; /* only the pixels that the acuity requires are drawn */

    /* State while a frame is drawn, see watch.c. */
    struct tia_event queue[VIEWER_QUEUE]; /* events that came while the frame was drawn */
    unsigned queued;
    uint64_t lights_us;         /* time when the frame's lights were set */
    uint64_t begun_us, look_us; /* start of the frame; time of the next check for events */
    bool outdated;              /* an event with an effect came after events were last handled */
    bool answered;              /* a picture of this frame has been shown */
    bool gives_up, gave_up;     /* this frame is to be given up; the frame before was given up */
    bool ends;                  /* a key, `stop` or a failed input ends the loop */
    int failure;                /* status of the input */

    /* State of drawing coarse to fine. */
    bool refining;
    unsigned pass;         /* the pass being drawn */
    uint32_t line;         /* share of the frame that is done, in units of 2^-16, for the progress line; 0: no line */
    uint64_t show_us;      /* time at which the picture of the unfinished pass is to be shown */
    uint64_t shown_us;     /* time when this frame was last shown; until then, when it was begun */
    uint64_t showing_us;   /* time spent showing this frame so far */
    uint64_t last_us;      /* time that the last frame took to draw; 0: unknown */
    uint64_t show_cost_us; /* time that the last picture took to show */
    bool unfinished;       /* the last frame was drawn in motion, with fewer passes than a complete one */
    bool complete;         /* the canvas holds all of the last frame */

    /* State of frames with a pace, see pace.c. */
    uint32_t cost_ns;                    /* measured cost of a pixel; 0: unknown */
    uint32_t pass_pixels[VIEWER_PASSES]; /* pixels drawn in each pass of the last frame */

    uint64_t key_us; /* time of the oldest key press that the next frame will show */
    struct held held[VIEWER_HELD_KEYS];
    struct tia_event last; /* the event that has ended the loop; its key is 0 if there is none */
    uint32_t frame;
    bool changed;  /* the screen is out of date */
    bool covered;  /* only the overlay on the picture is out of date */
    bool switched; /* a key has changed the technique since the last frame */
    bool pressed;  /* a key has changed the lights since the last frame */
    bool showing;  /* the display has not yet shown all of the last frame */
    bool keeps;    /* the viewer's lights.kept holds the kept_count lights of the last picture */
    uint32_t kept_count;
};

static inline uint64_t viewer_now(const struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;
    return v->ports.clock ? v->ports.clock->now_us(v->ports.clock_ctx) : 0;
}

/* Returns the number of samples per pixel if passes add them step by step; else 1. */
static inline uint32_t viewer_spp(const struct loop *loop)
{
    uint32_t spp = loop->base->integration.spp;

    return !loop->sums ? 1 : spp ? spp : TIA_SPP_DEFAULT;
}

static inline tia_rgb565 *viewer_canvas_at(const struct loop *loop, unsigned x, unsigned y)
{
    return loop->canvas + (size_t)y * loop->mode.width + x;
}

static inline int viewer_mode(struct loop *loop, struct tia_mode *mode)
{
    int status = loop->viewer->ports.display->mode(loop->viewer->ports.display_ctx, mode);

    loop->showing = loop->showing || status == TIA_BUSY;
    return status == TIA_BUSY ? TIA_OK : status;
}

/* Updates the viewer's `state`. */
static inline void viewer_tell(struct loop *loop)
{
    struct tia_viewer_state *state = loop->viewer->state;

    loop->state.time = loop->plays ? loop->time : loop->viewer->pacing.time;
    if (!state)
        return;
    loop->state.goes_on = state->goes_on;
    *state = loop->state;
}

/* Runs the loop, see tia_viewer_run. `core` is the default for a viewer that has no core, or NULL. */
int tia_viewer_loop(struct tia_viewer *viewer, const struct tia_core *core, const struct viewer_more *more);

/* Applies a key press as tia_viewer_press does, if `check` accepts the lights. */
int tia_viewer_press_lights(scene_check *check, const struct tia_scene *scene, struct tia_light *lights,
                            uint32_t *count, uint32_t capacity, uint16_t key);

/* ---- press.c ---- */

/* True if a key event sets or moves lights. */
bool tia_viewer_lights(const struct loop *loop, const struct tia_event *event);
/* True if a key moves a light. */
bool tia_viewer_moves(const struct loop *loop, uint16_t key);
/* True if a key changes the technique for shadows. */
bool tia_viewer_is_switch(const struct loop *loop, uint16_t key);

/* ---- key_events.c ---- */

/* Handles the press of a key; returns VIEWER_QUIT when the key quits. */
int tia_viewer_take_key(struct loop *loop, const struct tia_event *event);
/* Handles all waiting events; returns VIEWER_QUIT when one of them quits. */
int tia_viewer_take_events(struct loop *loop);
/* Handles, while a frame is drawn, the events at the front of the queue that do not change the frame. */
void tia_viewer_take_quiet(struct loop *loop);
int tia_viewer_repeat_held(struct loop *loop);
/* Returns the earliest time at which a held key repeats; 0: no key is held. */
uint64_t tia_viewer_repeat_us(const struct loop *loop);

/* ---- control.c ---- */

/* Returns the effect of an event in any viewer. */
enum tia_effect tia_viewer_effect_of(const struct loop *loop, const struct tia_event *event);

/* Returns the effect of an event in a viewer that is not for spheres alone. */
enum tia_effect tia_viewer_effect(const struct loop *loop, const struct tia_event *event);
/* Handles an event that neither sets nor moves lights; VIEWER_QUIT when it ends the loop. */
int tia_viewer_control(struct loop *loop, const struct tia_event *event);
/* Restores the camera of the last frame that was drawn; false if the camera is the same. */
bool tia_viewer_go_back(struct loop *loop);
/* Merges a pointer's event with the last event of the queue; false when they cannot be merged. */
bool tia_viewer_joins(struct loop *loop, const struct tia_event *event);

/* ---- gaze.c ---- */

/* Updates the acuity after the mode or the gaze has changed. */
void tia_viewer_gaze(struct loop *loop);
/* Handles a pointer's event; true when it moves the gaze. */
bool tia_viewer_point(struct loop *loop, const struct tia_event *event);

/* ---- fill.c ---- */

/* Fills in the pixels of the canvas that were left out because of the gaze. */
int tia_viewer_fill(struct loop *loop);

/* ---- technique_switch.c ---- */

/* Selects the next technique for shadows. */
void tia_viewer_switch(struct loop *loop);

/* ---- play.c ---- */

/* Sets up the scene at the viewer's start time. */
int tia_viewer_play_begin(struct loop *loop);
/* Updates the scene before a frame. */
int tia_viewer_play(struct loop *loop);

/* ---- watch.c ---- */

/* Resets the state of watch.c before a frame. */
void tia_viewer_watch_begin(struct loop *loop);
/* Polls `stop` and the input while a frame is drawn, on any thread. Returns TIA_STOPPED or VIEWER_OUTDATED when drawing
 * is to end, else TIA_OK. */
int tia_viewer_watch(struct loop *loop);
/* A `stop` callback: true if tia_viewer_watch ends the frame. */
bool tia_viewer_stops(void *loop);

/* ---- present.c ---- */

/* Presents the frame and continues until all of it is shown. Meanwhile keys are polled, and may interrupt this as they
 * interrupt drawing; the rest is then shown later. */
int tia_viewer_present(struct loop *loop);
/* Continues with the rest of a frame. */
int tia_viewer_go_on(struct loop *loop);

/* ---- view_memory.c ---- */

/* Gets memory for the display's mode. */
int tia_viewer_prepare(struct loop *loop);
/* Prepares a view of the current scene. */
int tia_viewer_prepare_view(struct loop *loop);

static inline unsigned viewer_workers(const struct loop *loop)
{
    const struct tia_workers *workers = loop->viewer->job.workers;

    return workers && workers->count ? workers->count : 1;
}

/* ---- strips.c ---- */

/* Returns the rows of a tile when the display sets no limit: a multiple of VIEWER_STRIP. */
unsigned tia_viewer_strip_rows(const struct loop *loop);

/* ---- tiles.c ---- */

/* Draws a frame at once, tile by tile. */
int tia_viewer_draw_tiles(struct loop *loop);
struct tia_tile tia_viewer_tile(const struct loop *loop, unsigned index);
/* Runs a job for each tile, on the workers if the display allows it. The job stores its status in loop->status. */
int tia_viewer_run_tiles(struct loop *loop, void (*job)(void *loop, unsigned index));
bool tia_viewer_same_mode(const struct tia_mode *a, const struct tia_mode *b);

/* Sets the order in which a coarse frame's tiles are drawn, and returns the tile that is drawn as number `index`. */
void tia_viewer_set_order(struct loop *loop);
unsigned tia_viewer_in_order(const struct loop *loop, unsigned index);

/* ---- estimate.c ---- */

/* Returns the estimated time for the rest of a coarse frame for which spent_us has passed; microseconds. */
uint64_t tia_viewer_left_us(const struct loop *loop, uint64_t spent_us);

/* ---- pace.c ---- */

/* Returns the period of the viewer's `pace`; without a pace, VIEWER_PERIOD_US. */
uint64_t tia_viewer_period_us(const struct loop *loop);
/* True if anything in the picture moves. */
bool tia_viewer_is_moving(const struct loop *loop);
/* True if there is time for the next pass of a moving picture. */
bool tia_viewer_has_time(const struct loop *loop);
/* Records that the pass has drawn `pixels` in `us` microseconds. */
void tia_viewer_learn(struct loop *loop, uint32_t pixels, uint64_t us);
/* Returns the time, in microseconds, that all passes of the frame would have taken. */
uint64_t tia_viewer_whole_us(const struct loop *loop, const struct tia_frame *frame);

/* ---- refine.c ---- */

/* Returns the number of bytes for the canvas and, if `sums`, its sums of samples; 0: no canvas. */
uint64_t tia_viewer_canvas_size(const struct loop *loop, bool sums);
/* Sets the canvas and the sums up in `memory`, of the size that tia_viewer_canvas_size returned. */
void tia_viewer_set_canvas(struct loop *loop, void *memory, uint64_t size);
/* True if the next frame is to be drawn coarse to fine. */
bool tia_viewer_refines(const struct loop *loop);
/* Draws a frame coarse to fine, and sets frame->draw_us. */
int tia_viewer_draw_passes(struct loop *loop, struct tia_frame *frame);

/* ---- refine_pass.c ---- */

/* Returns the number of bytes for sums of samples; 0: no sums. */
uint64_t tia_viewer_sums_size(const struct loop *loop);
/* Returns the number of passes of a complete frame. */
unsigned tia_viewer_passes(const struct loop *loop);
/* Returns the size of a pass's blocks. */
unsigned tia_viewer_block(unsigned pass);
/* True if passes draw rows in place of blocks. */
bool tia_viewer_by_rows(const struct loop *loop);
/* Returns the number of samples that each pixel has after `passes` passes. */
uint32_t tia_viewer_samples(const struct loop *loop, unsigned passes);
/* Returns the share of all samples that is drawn after `passes` passes, in units of 2^-16. */
uint32_t tia_viewer_share(const struct loop *loop, unsigned passes);
/* Draws the part of loop->pass that is in a tile; *drawn counts the pixels that had no sample before. */
int tia_viewer_refine_tile(struct loop *loop, struct tia_tile tile, uint32_t *drawn);

/* Copies the canvas onto the display. */
int tia_viewer_copy(struct loop *loop);
/* Copies an incomplete canvas onto the display after the loop, if it has been shown and the display is still the
 * same. */
void tia_viewer_copy_last(struct loop *loop);

/* Returns the technique for shadows that follows the scene's, in the order of tia_shadows_name cyclically, among those
 * that the scene qualifies for; TIA_SHADOWS_TRACED if the scene's is invalid. */
enum tia_shadows tia_next_shadows(const struct tia_scene *scene);

#endif
