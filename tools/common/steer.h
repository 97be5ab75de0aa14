/* steer.h - camera movement by keys and pointers: shift and arrows, page up and down, h j k l, + and -, a drag. */
#ifndef TOOLS_COMMON_STEER_H
#define TOOLS_COMMON_STEER_H

#include <tia/viewer.h>

/* State of the pointer; all zero at first. */
struct steer {
    bool has_place; /* x and y are the last position of the pointer */
    int32_t x, y;
};

bool steer_points(const struct tia_event *event); /* true if the event comes from a pointer */
bool steer_is_arrow(uint16_t key);                /* arrow keys, page up and page down */
bool steer_takes(const struct tia_event *event);  /* true for a key that moves the camera */

/* Moves the camera by an event of a pointer or of a key that moves it. Returns TIA_EFFECT_CAMERA, or TIA_EFFECT_NONE if
 * the pointer's event does not move the camera. A camera without a reference point gets one from the scene. */
enum tia_effect steer(struct steer *steer, const struct tia_scene *scene, const struct tia_event *event,
                      struct tia_camera *camera);

#endif
