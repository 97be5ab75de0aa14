/* viewer.h - the interactive loop, for any display and input, with or without an OS.
 *
 * Polls all waiting keys, moves the light, draws, shows, and sleeps when nothing happens.
 * Arrow keys move the first light by 1 along x and z, page up and down along y: once at the
 * press, and while a key is held, after TIA_HOLD_DELAY_US, once every TIA_HOLD_STEP_US. Ambient
 * lights, which are nowhere, are passed over; of a directional light the point at the distance 1
 * from which it comes moves by 1/16. Keys of the scene's bindings put lights. Every other key quits.
 *
 * A scene with tracks plays, from `time` to its last keyframe and then again; at most once every
 * TIA_PLAY_STEP_US a frame is drawn. A light that a key has put or moved stays where the key left it,
 * the others follow their tracks.
 */
#ifndef TIA_VIEWER_H
#define TIA_VIEWER_H

#include <tia/port.h>

#define TIA_HOLD_DELAY_US 250000u
#define TIA_HOLD_STEP_US 33333u
#define TIA_PLAY_STEP_US 16666u

/* One frame, told after it was presented. */
struct tia_frame {
    uint32_t number;  /* from 0 */
    bool relit;       /* the hits of the frame before were used */
    uint64_t draw_us; /* drawing, without waiting for the display */
    uint64_t key_us;  /* from the oldest key shown by this frame to the end of present;
                         0 when no key led to it or the clock is not known */
};

struct tia_viewer {
    /* What to draw and with which arithmetic. */
    const struct tia_core *core; /* NULL: tia_core_q16 */
    const struct tia_scene *scene;
    struct tia_light *lights; /* room for light_capacity lights, the scene's among them */
    uint32_t light_capacity;
    bool *held;                 /* with tracks, room for as many flags: lights that a key holds */
    struct tia_options options; /* `path_hash` must be NULL */
    uint32_t frame_limit;       /* stop after so many frames; 0: no limit */
    const uint16_t *keys;       /* pressed before the first frame; NULL: none */
    size_t key_count;
    tia_q16 time;     /* of the scene's tracks, at the first frame */
    uint32_t rate[2]; /* frame n is drawn at time + n rate[1]/rate[0], each 1..1000000: for films, with a
                         frame_limit; 0: by the clock */

    /* Where to draw, what to listen to. input may be NULL with a frame_limit: then frames are
     * drawn one after the other. clock may be NULL: then held keys do not repeat. */
    const struct tia_display *display;
    const struct tia_input *input;
    const struct tia_clock *clock;
    const struct tia_workers *workers;
    void *display_ctx, *input_ctx, *clock_ctx, *workers_ctx;

    /* Memory for the view and the hits. memory(ctx, size) returns at least `size` bytes aligned
     * for uint64_t, whose old contents may be gone, or NULL; asked again when the mode changes.
     * Where a whole frame's hits do not fit, those of one tile do, and nothing is relit. */
    void *(*memory)(void *ctx, size_t size);
    void *memory_ctx;

    /* NULL, or called after each frame. Not 0 ends the loop with that status. */
    int (*frame_done)(void *ctx, const struct tia_frame *frame);
    void *frame_ctx;
    const volatile int *stop; /* NULL, or the loop ends when it is not 0 */
};

/* Runs until a quitting key, the frame limit or *stop; then TIA_OK. Display and input must be
 * open and stay so. Errors: what the ports return, TIA_ERR_RANGE, TIA_ERR_MEMORY. */
int tia_viewer_run(struct tia_viewer *viewer);

/* Applies one key press to the lights of a scene: 1 when they changed, 0 when the key does
 * nothing to them but is taken, TIA_ERR_ARGUMENT when it is a quitting key. *count lights are
 * in use of the array's `capacity`. A move that would leave the accepted range is not made. */
int tia_press(const struct tia_scene *scene, struct tia_light *lights, uint32_t *count, uint32_t capacity,
              uint16_t key);

/* Which light a key puts or moves: its index, `count` when it adds one, TIA_NO_LIGHT when none. */
#define TIA_NO_LIGHT UINT32_MAX
uint32_t tia_key_light(const struct tia_scene *scene, const struct tia_light *lights, uint32_t count, uint16_t key);

/* The time of frame `frame` of a film with rate[0]/rate[1] frames a second, each 1..1000000: from `start`, to
 * the nearest 2^-16 s, at most INT32_MAX. */
tia_q16 tia_frame_time(tia_q16 start, uint32_t frame, const uint32_t rate[2]);

#endif
