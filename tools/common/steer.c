#include "steer.h"

#include <tia/orbit.h>

#define STEP TIA_Q16(5)       /* degrees of a step by a key that orbits */
#define PIXEL_STEP TIA_Q16(1) /* degrees of a mouse's movement by four pixels */
#define TURN 180              /* degrees of a drag through the whole picture */

bool steer_points(const struct tia_event *event)
{
    return event->kind == TIA_EVENT_POINT || event->kind == TIA_EVENT_MOVE;
}

bool steer_is_arrow(uint16_t key)
{
    return key >= TIA_KEY_LEFT && key <= TIA_KEY_PAGE_DOWN;
}

bool steer_takes(const struct tia_event *event)
{
    uint16_t key = event->key;

    return (steer_is_arrow(key) && event->shift) || key == 'h' || key == 'j' || key == 'k' || key == 'l' ||
           key == TIA_KEY_PLUS || key == TIA_KEY_MINUS;
}

static void orbit(const struct tia_scene *scene, struct tia_camera *camera, tia_q16 right, tia_q16 up)
{
    tia_camera_aim(camera, scene);
    tia_camera_orbit(camera, right, up);
}

/* Moves the camera by a pointer. The scene follows the pointer, so the eye moves the other way. */
static enum tia_effect point(struct steer *steer, const struct tia_scene *scene, const struct tia_event *event,
                             struct tia_camera *camera)
{
    int32_t x = event->x * (PIXEL_STEP / 4), y = event->y * (PIXEL_STEP / 4);
    bool begins = event->kind == TIA_EVENT_POINT && !steer->has_place;

    if (event->kind == TIA_EVENT_POINT) {
        x = (event->x - steer->x) * TURN;
        y = (event->y - steer->y) * TURN;
        steer->x = event->x;
        steer->y = event->y;
        steer->has_place = event->drag;
    }
    if (!event->drag || begins || (!x && !y))
        return TIA_EFFECT_NONE;
    orbit(scene, camera, -x % TIA_Q16(180), y % TIA_Q16(180));
    return TIA_EFFECT_CAMERA;
}

static void walk(const struct tia_scene *scene, struct tia_camera *camera, uint16_t key)
{
    tia_camera_aim(camera, scene);
    tia_camera_walk(camera, (key == TIA_KEY_RIGHT) - (key == TIA_KEY_LEFT),
                    (key == TIA_KEY_PAGE_UP) - (key == TIA_KEY_PAGE_DOWN), (key == TIA_KEY_UP) - (key == TIA_KEY_DOWN));
}

enum tia_effect steer(struct steer *steer, const struct tia_scene *scene, const struct tia_event *event,
                      struct tia_camera *camera)
{
    uint16_t key = event->key;

    if (steer_points(event))
        return point(steer, scene, event, camera);
    if (steer_is_arrow(key))
        walk(scene, camera, key);
    else if (key == TIA_KEY_PLUS || key == TIA_KEY_MINUS)
        tia_camera_zoom(camera, key == TIA_KEY_PLUS);
    else
        orbit(scene, camera, ((key == 'l') - (key == 'h')) * STEP, ((key == 'k') - (key == 'j')) * STEP);
    return TIA_EFFECT_CAMERA;
}
