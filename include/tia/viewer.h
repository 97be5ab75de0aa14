/* viewer.h - the interactive loop, for any display and input, with or without an OS.
 *
 * Each round handles all waiting keys, draws and shows a frame when something changed, and otherwise sleeps. The arrow
 * keys move the first light by 1 along x and z, page up and page down along y: once when pressed and, while held for
 * longer than TIA_HOLD_DELAY_US, every TIA_HOLD_STEP_US. Between two pictures at most TIA_HOLD_STEPS steps are made,
 * and further ones are dropped, so that the eye can follow. The first light is the first that is not ambient, since an
 * ambient light has no position. A directional light is rotated: the point at the distance 1 from which it shines is
 * moved by 1/16. The keys of the scene's bindings set lights. Unless the scene binds it, TIA_KEY_SHADOWS selects the
 * next technique for shadows that the scene qualifies for, if the caller allows it. Every other key quits. Keys are
 * also polled while a frame is drawn: a key that quits ends the frame at once; a key that moves a light ends it at the
 * next tile if it has taken 250 ms, but never two frames in a row. In a scene that plays, such a key ends the frame at
 * once if the next one can be shown in blocks or rows.
 *
 * A frame that rays draw, and that takes longer than a display's period, is shown coarse to fine: first every 16th
 * pixel of every 16th row as a block, then every 8th of every 8th, and so on, until it is complete. A key that moves a
 * light then ends it at once. For a frame of more than a second, a line at the picture's lower edge shows the progress.
 * This needs a `clock`, an `input` and no `frame_limit`; while a scene plays, only a frame that follows a key or takes
 * 250 ms is shown in blocks.
 *
 * With an `estimator`, each pixel of a sampled picture has one sample at first. Once all pixels are drawn, the number
 * of samples is doubled, again and again, up to that of the scene. Each sample is computed once. This takes 24 bytes a
 * pixel; in pictures of more than 2^23 pixels, each pixel gets all samples at once.
 *
 * A rasterised picture that follows a key or takes 250 ms is shown in two steps: first every 16th row, then all rows.
 *
 * With a gaze, if rays draw the scene, pixels that the eye cannot distinguish from their neighbours are left out, and
 * the gaze follows a pointer.
 *
 * With `pace`, each frame of a motion (a scene that plays, a key that is held) is as fine as time allows: as many
 * passes are drawn as fit the period, estimated by the cost of earlier pixels. When nothing moves, the remaining passes
 * follow.
 *
 * A scene with tracks plays from `time` to its last keyframe in a loop, with at most one frame every
 * TIA_PLAY_STEP_US. A light that a key has set or moved stays there; the others follow their tracks.
 */
#ifndef TIA_VIEWER_H
#define TIA_VIEWER_H

#include <tia/gaze.h>
#include <tia/integrator.h>
#include <tia/port.h>

#ifdef __cplusplus
extern "C" {
#endif

#define TIA_HOLD_DELAY_US 250000u
#define TIA_HOLD_STEP_US 33333u
#define TIA_HOLD_STEPS 3
#define TIA_PLAY_STEP_US 16666u
#define TIA_KEY_SHADOWS 't'

/* Data of a picture, reported when it is drawn, and after it is shown. A frame that takes long has coarse pictures
 * before the complete one, with the same number and `block` above 1. */
struct tia_frame {
    uint32_t number;          /* number of the frame, from 0 */
    uint16_t block;           /* 1: the frame is complete; else the size of its largest blocks, in pixels, at least 2 */
    uint32_t samples;         /* coarse picture of samples: smallest number of samples of a pixel; else 0 */
    uint16_t done;            /* coarse picture: share of the frame's samples drawn so far, in units of 2^-16 */
    uint32_t pixels;          /* number of pixels drawn; the others repeat these, or are interpolated from them */
    bool moving;              /* with `pace`: the picture moves */
    uint64_t left_us;         /* coarse picture: microseconds that the rest takes, estimated */
    bool relit;               /* only lights changed: the previous frame's hits were used again */
    uint64_t draw_us;         /* time to draw, microseconds, without waiting for the display */
    enum tia_shadows shadows; /* technique for shadows */
    uint64_t key_us;  /* latency in microseconds, from the oldest key press that this frame shows to the end of present;
                         0 when there was none, its time is unknown, or the frame is not shown yet, and in all but the
                         first of a frame's coarse pictures */
    const char *simd; /* name of the instruction set that drew the picture, see tia_view_simd */
};

/* The effect of an event. */
enum tia_effect {
    TIA_EFFECT_NONE,
    TIA_EFFECT_PICTURE, /* the picture is shown again: its overlay has changed */
    TIA_EFFECT_CAMERA,  /* the camera has moved */
    TIA_EFFECT_HOME,    /* the camera is back at its first position */
    TIA_EFFECT_END      /* the loop ends */
};

/* Handlers of keys and pointers that do not move lights. A scene's own keys come first, then those that move lights,
 * unless typed with Shift, then TIA_KEY_TAB, which chooses the next light to move, and TIA_KEY_SPACE, which pauses and
 * resumes a scene that plays. */
struct tia_control {
    /* Returns the effect that the event would have; changes nothing. May be called on any thread that
     * calls the viewer's `stop`. */
    enum tia_effect (*weigh)(void *ctx, const struct tia_event *event);
    /* Handles the event. *camera is the present camera, which `act` may change; a camera that tia_scene_check refuses
     * is ignored. Keys that move lights are passed to `act` as well when there is no light to move. An event for which
     * `weigh` returns TIA_EFFECT_NONE is passed even between two pictures of a frame that is drawn coarse to fine. An
     * event of TIA_EFFECT_END is passed when the loop is over; if a coarse picture was shown, the display's memory then
     * holds as much of the frame as was drawn. */
    enum tia_effect (*act)(void *ctx, const struct tia_event *event, struct tia_camera *camera);
};

/* The changes that keys have made. */
struct tia_viewer_state {
    bool goes_on; /* set by the caller: begin with this state and the viewer's lights, not with the scene's */
    bool moved;   /* keys have moved the camera */
    bool paused;
    bool incomplete; /* the display does not show all of these changes yet */
    struct tia_camera camera;
    /* Number of lights, at most lights.capacity; index of the light that keys move (if that is ambient, they move the
     * next one). */
    uint32_t light_count, light;
    tia_q16 time; /* seconds */
};

/* The present lights, those of the scene and those that keys add: arrays of `capacity` elements. */
struct tia_viewer_lights {
    struct tia_light *array;
    struct tia_light *kept; /* NULL, or memory for the lights of the last picture. With it, a key that moves a light too
                               far away for the scene's shadows has no effect; without it, the key ends the loop */
    bool *detached;         /* only for scenes with tracks: the lights that keys have set or moved */
    uint32_t capacity;
};

/* The times of frames. All zero: they follow the clock, and no frame is made coarser to keep a rate. */
struct tia_viewer_pacing {
    uint32_t frame_limit; /* stop after this many frames; 0: no limit */
    tia_q16 time;         /* time of the first frame, seconds, for scenes with tracks */
    uint32_t rate[2];     /* films: frame n shows `time` + n rate[1]/rate[0]; each 1..1000000; needs a frame_limit */
    uint32_t pace[2]; /* frames a second to keep in motion, pace[0]/pace[1], each 1..1000000; pace[0] = 0: no pace */
};

/* `input` may be NULL with a frame_limit: frames are then drawn one after the other. `clock` may be NULL: held keys
 * then do not repeat. */
struct tia_viewer_ports {
    const struct tia_display *display;
    const struct tia_input *input;
    const struct tia_clock *clock;
    void *display_ctx, *input_ctx, *clock_ctx;
};

/* The caller's functions. All but `memory` may be NULL. */
struct tia_viewer_hooks {
    /* Returns memory for the view, the hits and other data: at least `size` bytes, aligned for uint64_t, or NULL.
     * Memory that the function returned before may be discarded. Called again when the mode or the technique changes.
     * When a whole frame's hits do not fit, the viewer takes memory for one tile's, and traces every frame anew. */
    void *(*memory)(void *ctx, size_t size);

    /* Called when a picture is drawn, before it is shown: anything that the function draws onto the display is shown
     * with it. */
    void (*frame_drawn)(void *ctx, const struct tia_frame *frame);

    /* Called after each picture. A result other than 0 ends the loop with that status. */
    int (*frame_done)(void *ctx, const struct tia_frame *frame);

    const struct tia_control *control; /* NULL: other keys end the loop. Needs the viewer's `variant` */
    void *ctx;                         /* first argument of these functions, and of the control's */
};

struct tia_viewer {
    const struct tia_core *core;           /* NULL: tia_core_q16 */
    const struct tia_simd *simd;           /* NULL: plain C; see tia/simd.h */
    const struct tia_estimator *estimator; /* NULL, or the core's, to show samples as they are drawn; others: ignored */
    const struct tia_scene *scene;
    struct tia_scene *variant; /* NULL, or memory for a copy of the scene: then TIA_KEY_SHADOWS changes the technique */
    struct tia_viewer_lights lights;
    struct tia_viewer_pacing pacing;
    struct tia_viewer_ports ports;
    struct tia_viewer_hooks hooks;

    /* The workers draw tiles; the vector units have memory for each. When `stop` returns true, as after a signal, the
     * loop ends. `stop` and input->poll are called between frames and, on any thread that draws, about every 20 ms
     * while a frame is drawn. */
    struct tia_job job;

    bool dither;          /* ordered dithering, see struct tia_options */
    const uint16_t *keys; /* keys to press before the first frame; NULL: none */
    size_t key_count;
    struct tia_gaze gaze;
    struct tia_viewer_state *state; /* NULL, or is updated with each change */
};

/* Runs until a key quits, the frame limit is reached or `stop` returns true; then returns TIA_OK. The caller opens
 * display and input before and closes them afterwards. Errors: those of the ports; TIA_ERR_ARGUMENT when a member is
 * missing or out of its range; TIA_ERR_RANGE when tia_scene_check refuses the scene; TIA_ERR_MEMORY, also when the
 * memory is not aligned. */
int tia_viewer_run(struct tia_viewer *viewer);

/* Runs the viewer for scenes of spheres alone, see tia_core_spheres; TIA_ERR_RANGE for others. `core` must be set.
 * Frames are not drawn coarse to fine, and all keys but those that set or move lights quit. The code for other scenes
 * is not linked. */
int tia_viewer_run_spheres(struct tia_viewer *viewer);

/* Applies a key press to the lights: the first *count elements of an array of `capacity`. Returns 1 when they changed;
 * 0 when the key has a meaning but changes nothing; TIA_ERR_ARGUMENT when the key quits, or *count is above the
 * capacity. A light that would leave the range of tia_scene_check does not move. */
int tia_viewer_press(const struct tia_scene *scene, struct tia_light *lights, uint32_t *count, uint32_t capacity,
                     uint16_t key);

/* Returns the index of the light that a key sets or moves; `count` when the key adds one; TIA_NO_LIGHT when none. */
#define TIA_NO_LIGHT UINT32_MAX
uint32_t tia_viewer_key_light(const struct tia_scene *scene, const struct tia_light *lights, uint32_t count,
                              uint16_t key);

/* Returns the time of frame number `frame` of a film that starts at `start` and shows rate[0]/rate[1] frames per
 * second, each 1..1000000: rounded to nearest, at most INT32_MAX. Without a rate, NULL, it is `start`. */
tia_q16 tia_viewer_frame_time(tia_q16 start, uint32_t frame, const uint32_t rate[2]);

#ifdef __cplusplus
}
#endif

#endif
