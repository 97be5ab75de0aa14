#include "lights.h"

#include <stdlib.h>
#include <string.h>

#include <tia/viewer.h>

bool lights_copy(struct lights *lights, const struct tia_scene *scene)
{
    /* A key adds at most the one light that it names. */
    lights->count = scene->light_count;
    lights->capacity = scene->light_count + scene->binding_count + 1;
    lights->array = calloc(lights->capacity, sizeof *lights->array);
    if (lights->array == NULL) {
        return false;
    }
    if (lights->count > 0) {
        memcpy(lights->array, scene->lights, lights->count * sizeof *lights->array);
    }
    return true;
}

void lights_press(struct lights *lights, const struct tia_scene *scene, const uint16_t *keys, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        (void)tia_press(scene, lights->array, &lights->count, lights->capacity, keys[i]);
    }
}
