/* steer.h - what keys and pointers do to a camera: shift and arrows, page up and down, h j k l, + and -, a drag. */
#ifndef TOOLS_COMMON_STEER_H
#define TOOLS_COMMON_STEER_H

#include <tia/viewer.h>

/* All zero at first. */
struct steer {
    bool has_place; /* where the pointer was last */
    int32_t x, y;
};

bool steer_points(const struct tia_event *event); /* it comes from a pointer */
bool steer_is_arrow(uint16_t key);                /* or page up or down */
bool steer_takes(const struct tia_event *event);  /* a key that moves the camera */

/* Moves the camera, for an event of a pointer or a key that is taken: TIA_EFFECT_CAMERA, or TIA_EFFECT_NONE when it
 * moves nothing. The scene says what a camera without a reference point looks at. */
enum tia_effect steer(struct steer *steer, const struct tia_scene *scene, const struct tia_event *event,
                      struct tia_camera *camera);

#endif
