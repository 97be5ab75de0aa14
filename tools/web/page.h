/* page.h - the viewer in a page: one scene, one picture, the page's settings. Its parts share this state, since a
 * core (struct tia_core) has no context. */
#ifndef TOOLS_WEB_PAGE_H
#define TOOLS_WEB_PAGE_H

#include "common/light_copy.h"
#include "common/scene/scene_load.h"
#include "common/steer.h"
#include "common/views/views.h"
#include "web/web.h"

enum arithmetic { ARITHMETIC_Q16, ARITHMETIC_F64, ARITHMETIC_DIFFERENCE };

struct settings {
    uint16_t width, height;
    enum arithmetic arithmetic;
    enum view view;
    bool rays;          /* show the rays of the pixel under the pointer */
    int32_t integrator; /* enum tia_integrator; -1: the scene's */
    uint32_t samples;   /* samples of a pixel; 0: the scene's */
};

struct session {
    struct settings settings;
    struct web_screen screen;
    struct scene_file file;
    bool loaded;
    struct tia_scene scene, variant; /* the scene with the settings applied; the copy for the viewer */
    struct lights lights;
    struct tia_binding *bindings; /* the scene's bindings, and one for the pointer, which sets a light */
    struct tia_viewer_state state;
    enum tia_shadows shadows; /* of the state that web_take_kept took over */
    struct steer steer;
    uint32_t spp; /* samples of a pixel to draw one by one; 0: Whitted's integrator, or not drawn one by one */
    bool polled;  /* an event has been polled */

    /* The pixel under the pointer. */
    bool rays_due;
    int32_t pointer_x, pointer_y; /* position as in struct tia_event; negative: not on the picture */

    struct web_frame frame; /* data of the last frame */
    void *memory, *kept;
    size_t memory_size;
    char why[SCENE_WHY];
    char *report; /* of the scene that was refused last; NULL: none */
};

extern struct session session;

/* The core for the settings, which records its view. page_core.c */
struct seat {
    struct tia_view *view; /* view of the last frame; NULL before the first frame */
    const struct tia_core *base;
};
extern struct seat seat;
const struct tia_core *seat_core(void);

/* A core that shows the pixels where fixed point and doubles differ: a channel by one level, a channel by more, or the
 * path of a ray. difference.c */
extern const struct tia_core difference_core;
/* Numbers of these three kinds of pixels. */
extern uint32_t difference_counts[3];
/* Enlarges the pixels that differ, if they are few. */
void difference_spread(tia_rgb565 *pixels, unsigned width, unsigned height);

/* Restarts the drawing of samples. idle_samples.c */
void samples_reset(void);
/* True if there are samples to draw. */
bool samples_left(void);
/* Draws a row of samples of the seat's view, and shows the picture from time to time. Returns TIA_STOPPED, or a
 * negative status on failure. */
int samples_go_on(void);
/* Shows the samples so far. Returns false if some pixels have none. */
bool samples_show(void);
/* Stores the sums of samples first .. end - 1 of a tile's pixels, row by row. Returns a status as struct
 * tia_estimator's `sample`. */
int samples_sum(const struct tia_view *view, struct tia_tile tile, uint32_t first, uint32_t end, struct tia_sum *sums);
/* Returns a channel of a pixel from its sum of `count` samples, 0..2^bits - 1; the pixel. */
unsigned samples_level(const struct tia_integration *how, enum tia_tone tone, int64_t sum, uint32_t count,
                       unsigned bits);
tia_rgb565 samples_pixel(const struct tia_integration *how, const struct tia_sum *sum, uint32_t count);

/* Control and input of the session. page_control.c */
extern const struct tia_control session_control;
extern const struct tia_input session_input; /* input; its context is that of web_input */

/* Returns the light that keys move, or TIA_NO_LIGHT. light_control.c */
uint32_t light_chosen(void);
/* Stores the chosen light and its position in the picture to `frame`. */
void light_tell(struct web_frame *frame);
/* Moves the chosen light by `right` and `down`, in 2^-16 of the picture's width and height. Returns false if there is
 * no light that can be moved, or if its new position is not valid. */
bool light_drag(int32_t right, int32_t down);

/* Prepares the scene, the lights and the screen for the settings; `goes_on`: with the lights of the session's state,
 * not the scene's. Returns false if there is no memory. */
bool session_begin(bool goes_on);
/* Stores the reason of a failure, for web_why. */
void session_failed(int status);
/* Copies the state from which another worker can continue. Returns its size, 0 if there is none. */
uint32_t session_keep(const void **state);

/* Draws rows into the session's screen, after web_rows_begin. page_rows.c */
int rows_draw(unsigned y, unsigned count);

/* Sharing of a slow picture with helpers. page_share.c */
void share_begin(void); /* begins a frame */
void share_end(void);   /* the helpers may stop */
/* Asks helpers for parts of samples, if they can draw them. */
void share_samples(void);
/* Returns the share of the frame's pixels that helpers have drawn, in 2^-16. */
uint32_t share_copied(void);
/* Replaces functions of `drawing`; `base` has the functions that draw. */
void share_wrap(const struct tia_drawing *base, struct tia_drawing *drawing);

/* Shows the picture, with its checksum when it is complete. */
void session_show(void);

/* Returns the camera of the picture. */
const struct tia_camera *session_camera(void);

#endif
