/* press_any.c - the effect of a key press on the lights of any scene. */
#include "loop.h"
#include "scene/check/scene_check.h"

int tia_viewer_press(const struct tia_scene *scene, struct tia_light *lights, uint32_t *count, uint32_t capacity,
                     uint16_t key)
{
    return tia_viewer_press_lights(tia_check_scene, scene, lights, count, capacity, key);
}
