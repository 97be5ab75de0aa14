#include "moment.h"

#include <stdio.h>
#include <stdlib.h>

#include "film.h"
#include "ports.h"

/* Memory of `size` bytes whose contents may be lost. */
static bool take(void **memory, size_t *bytes, size_t size)
{
    if (*memory == NULL || *bytes < size) {
        free(*memory);
        *memory = malloc(size > 0 ? size : 1);
        *bytes = *memory != NULL ? size : 0;
    }
    return *memory != NULL;
}

/* What was right in the file may leave its range on the way from keyframe to keyframe. */
static int check(struct moment *moment, tia_q16 time)
{
    struct tia_fault fault;
    int status = tia_scene_check(moment->scene, &fault);
    if (status != TIA_OK) {
        (void)snprintf(moment->why, PORT_WHY, "scene: at %.3f s: %s %u: %s: %s", (double)time / TIA_Q16_ONE,
                       fault.thing, (unsigned)fault.index, fault.field, fault.rule);
    }
    return status;
}

/* moment->scene at the time of a frame; without boxes. */
static int move(struct moment *moment, uint32_t frame)
{
    const struct tia_scene *scene = &moment->options->scene;
    tia_q16 time = film_time(moment->options, frame);
    moment->scene = scene;
    if (scene->track_count > 0) {
        size_t size = tia_scene_at_size(scene);
        if (!take(&moment->moving, &moment->moving_bytes, size)) {
            return TIA_ERR_MEMORY;
        }
        int status = tia_scene_at(&moment->moved, moment->moving, size, scene, time);
        if (status != TIA_OK) {
            return status;
        }
        moment->scene = &moment->moved;
    }
    return check(moment, time);
}

static int build_boxes(struct moment *moment)
{
    struct tia_scene *moved = &moment->moved;
    if (moment->scene != moved || moment->options->scene.bvh == NULL) {
        return TIA_OK;
    }
    size_t size = tia_bvh_size(moved);
    if (!take(&moment->boxes, &moment->boxes_bytes, size)) {
        return TIA_ERR_MEMORY;
    }
    return tia_bvh_build(&moved->bvh, moment->boxes, size, NULL, moved);
}

static int prepare_view(struct moment *moment)
{
    const struct options *options = moment->options;
    const struct lights *lights = &moment->lights;
    size_t size = options->core->view_size(moment->scene, lights->capacity);
    if (!take(&moment->view_memory, &moment->view_bytes, size)) {
        return TIA_ERR_MEMORY;
    }
    struct rotation rotation = film_turn(options);
    int status = options->core->view_init(&moment->view, moment->view_memory, size, moment->scene, lights->capacity,
                                          rotation.width, rotation.height);
    return status == TIA_OK ? options->core->set_lights(moment->view, lights->array, lights->count) : status;
}

int moment_begin(struct moment *moment, const struct options *options, char *why)
{
    *moment = (struct moment){.options = options, .why = why};
    int status = move(moment, 0);
    if (status == TIA_OK && !lights_copy(&moment->lights, moment->scene)) {
        status = TIA_ERR_MEMORY;
    }
    if (status == TIA_OK) {
        lights_press(&moment->lights, moment->scene, options->keys, options->key_count);
    }
    return status;
}

int moment_at(struct moment *moment, uint32_t frame)
{
    if (moment->view != NULL && moment->options->scene.track_count == 0) {
        return TIA_OK;
    }
    int status = move(moment, frame);
    if (status == TIA_OK) {
        status = build_boxes(moment);
    }
    if (status == TIA_OK) {
        lights_follow(&moment->lights, moment->scene);
        status = prepare_view(moment);
    }
    return status;
}

void moment_end(struct moment *moment)
{
    free(moment->moving);
    free(moment->boxes);
    free(moment->view_memory);
    lights_free(&moment->lights);
}
