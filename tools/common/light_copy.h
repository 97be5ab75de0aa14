/* light_copy.h - a copy of the scene's lights that keys can move. */
#ifndef TOOLS_COMMON_LIGHT_COPY_H
#define TOOLS_COMMON_LIGHT_COPY_H

#include <tia/scene.h>

struct lights {
    struct tia_light *array, *kept; /* the lights, and memory of the same size: see struct tia_viewer_lights */
    bool *detached;                 /* marks lights that a key has set or moved: they no longer follow their tracks */
    uint32_t count, capacity;
};

/* Copies the lights, and allocates memory for those that the scene's keys can add. Returns false if there is no
 * memory. */
bool lights_copy(struct lights *lights, const struct tia_scene *scene);
void lights_free(struct lights *lights);

/* Applies `count` key presses to the lights. */
void lights_press(struct lights *lights, const struct tia_scene *scene, const uint16_t *keys, size_t count);

/* Sets all lights to those of the scene, except the lights that a key has set or moved. */
void lights_follow(struct lights *lights, const struct tia_scene *scene);

#endif
