#include "film_scene.h"

#include <stdio.h>
#include <stdlib.h>

#include "common/modules.h"
#include "fail.h"
#include "film_plan.h"
#include "ports.h"

/* Makes *memory at least `size` bytes large; its contents may be lost. */
static bool get_memory(void **memory, size_t *bytes, size_t size)
{
    if (!*memory || *bytes < size) {
        free(*memory);
        *memory = malloc(size > 0 ? size : 1);
        *bytes = *memory ? size : 0;
    }
    return *memory;
}

/* Checks the scene at `time`: values that are valid at two keyframes can be out of range between them. */
static int check(struct film_scene *film, tia_q16 time)
{
    struct tia_fault fault;
    int status = tia_scene_check(film->scene, &fault);
    if (status) {
        (void)snprintf(film->why, PORT_WHY, "scene: at %.3f s: %s %u: %s: %s", (double)time / TIA_Q16_ONE, fault.thing,
                       (unsigned)fault.index, fault.field, fault.rule);
    }
    return status;
}

/* Sets film->scene to the scene at the time of a frame. Does not update the hierarchy. */
static int set_time(struct film_scene *film, uint32_t frame)
{
    const struct tia_scene *scene = &film->options->scene;
    tia_q16 time = film_time(film->options, frame);
    film->scene = scene;
    if (tia_scene_moves(scene)) {
        size_t size = tia_scene_at_size(scene);
        if (!get_memory(&film->arrays, &film->arrays_bytes, size))
            return TIA_ERR_MEMORY;
        int status = tia_scene_at(&film->moved, film->arrays, size, scene, time, NULL);
        if (status)
            return status;
        film->scene = &film->moved;
    }
    return check(film, time);
}

/* Updates the hierarchy; its static part was built once, with the scene. */
static int move_bvh(struct film_scene *film)
{
    struct tia_scene *moved = &film->moved;
    if (film->scene != moved || !film->options->scene.bvh)
        return TIA_OK;
    size_t size = tia_bvh_move_size(moved);
    if (!get_memory(&film->bvh_memory, &film->bvh_bytes, size))
        return TIA_ERR_MEMORY;
    return tia_bvh_move(&moved->bvh, film->bvh_memory, size, moved, &film->options->scene, &film->job);
}

static int set_simd(struct film_scene *film)
{
    const struct options *options = film->options;
    size_t size =
        options->core->simd_size(options->core, options->simd, film->scene, film->lights.capacity, options->threads);
    if (!get_memory(&film->simd_memory, &film->simd_bytes, size))
        return TIA_ERR_MEMORY;
    return tia_view_set_simd(film->view, options->simd, film->simd_memory, size);
}

static int prepare_view(struct film_scene *film)
{
    const struct options *options = film->options;
    const struct lights *lights = &film->lights;
    size_t size = options->core->view_size(options->core, film->scene, lights->capacity);
    if (!get_memory(&film->view_memory, &film->view_bytes, size))
        return TIA_ERR_MEMORY;
    struct rotation rotation = film_rotation(options);
    int status = options->core->view_init(options->core, &film->view, film->view_memory, size, film->scene,
                                          lights->capacity, rotation.width, rotation.height, &film->job);
    int simd = !status ? set_simd(film) : TIA_OK; /* first, so that it draws the lights' shadow maps */
    if (!status && !simd)
        status = tia_view_set_lights(film->view, lights->array, lights->count);
    if (status)
        fail_view_reason(
            film->why, PORT_WHY, status,
            &(struct fail_view){film->scene, lights->array, lights->count, rotation.width, rotation.height});
    return status ? status : simd;
}

int film_scene_begin(struct film_scene *film, const struct options *options, char *why)
{
    film->options = options;
    film->why = why;
    int status = set_time(film, 0);
    if (!status && !lights_copy(&film->lights, film->scene))
        status = TIA_ERR_MEMORY;
    if (!status)
        lights_press(&film->lights, film->scene, options->keys, options->key_count);
    return status;
}

/* With --views, sets the camera of `scene` to that of view number `picture`. With --modules, sets the light field of
 * `scene` to *field, with the projector of module number `picture`. */
static void set_picture(struct tia_scene *scene, struct tia_light_field *field, const struct options *options,
                        uint32_t picture)
{
    const struct light_options *light = &options->light;
    const struct tia_camera line = scene->camera;

    if (light->views) {
        tia_light_field_camera(&scene->camera, &line, tia_light_field_place(&line, picture, light->views));
        return;
    }
    *field = light->field;
    field->projector.place = modules_place(picture, light->pictures, light->spacing);
    scene->field = field;
}

int film_scene_update(struct film_scene *film, uint32_t frame)
{
    const struct options *options = film->options;
    if (film->view && !tia_scene_moves(&options->scene) && !options->light.pictures)
        return TIA_OK;
    int status = set_time(film, frame);
    if (!status)
        status = move_bvh(film);
    if (!status && options->light.pictures) {
        film->pictured = *film->scene;
        set_picture(&film->pictured, &film->field, options, frame);
        film->scene = &film->pictured;
    }
    if (!status) {
        lights_follow(&film->lights, film->scene);
        status = prepare_view(film);
    }
    return status;
}

void film_scene_end(struct film_scene *film)
{
    free(film->arrays);
    free(film->bvh_memory);
    free(film->view_memory);
    free(film->simd_memory);
    lights_free(&film->lights);
}
