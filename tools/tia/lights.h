/* lights.h - the scene's lights in memory of the command's own, where keys can move them. */
#ifndef TOOLS_TIA_LIGHTS_H
#define TOOLS_TIA_LIGHTS_H

#include <tia/scene.h>

struct lights {
    struct tia_light *array;
    bool *held; /* those that a key has put or moved: they stay where it left them */
    uint32_t count, capacity;
};

/* A copy with room for those that the scene's keys may add. False: no memory. */
bool lights_copy(struct lights *lights, const struct tia_scene *scene);
void lights_free(struct lights *lights);

/* Presses `count` keys. */
void lights_press(struct lights *lights, const struct tia_scene *scene, const uint16_t *keys, size_t count);

/* Those that no key holds become the scene's. */
void lights_follow(struct lights *lights, const struct tia_scene *scene);

#endif
