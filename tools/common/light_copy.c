#include "light_copy.h"

#include <stdlib.h>
#include <string.h>

#include <tia/viewer.h>

bool lights_copy(struct lights *lights, const struct tia_scene *scene)
{
    /* each binding adds at most one light */
    lights->count = scene->light_count;
    lights->capacity = scene->light_count + scene->binding_count + 1;
    lights->array = calloc(lights->capacity, sizeof *lights->array);
    lights->kept = calloc(lights->capacity, sizeof *lights->kept);
    lights->detached = calloc(lights->capacity, sizeof *lights->detached);
    if (!lights->array || !lights->kept || !lights->detached)
        return false;
    if (lights->count > 0)
        memcpy(lights->array, scene->lights, lights->count * sizeof *lights->array);
    return true;
}

void lights_free(struct lights *lights)
{
    free(lights->array);
    free(lights->kept);
    free(lights->detached);
}

void lights_press(struct lights *lights, const struct tia_scene *scene, const uint16_t *keys, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        uint32_t light = tia_viewer_key_light(scene, lights->array, lights->count, keys[i]);
        if (tia_viewer_press(scene, lights->array, &lights->count, lights->capacity, keys[i]) > 0)
            lights->detached[light] = true;
    }
}

void lights_follow(struct lights *lights, const struct tia_scene *scene)
{
    for (uint32_t i = 0; i < scene->light_count; i++)
        if (!lights->detached[i])
            lights->array[i] = scene->lights[i];
}
