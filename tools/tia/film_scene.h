/* film_scene.h - the scene at the time of a frame, ready to be drawn. */
#ifndef TOOLS_TIA_FILM_SCENE_H
#define TOOLS_TIA_FILM_SCENE_H

#include "common/light_copy.h"
#include "options.h"

struct film_scene {
    const struct options *options;
    const struct tia_scene *scene; /* the scene at the time of the frame */
    struct tia_view *view;
    char *why;          /* receives the reason for a failure, [PORT_WHY] */
    struct tia_job job; /* job of long calls; its `stop` also stops drawing */

    /* Private. */
    struct tia_scene moved, pictured; /* the scene at the time of the frame; the same for one view or module */
    struct tia_light_field field;     /* light field for a module */
    void *arrays, *bvh_memory, *view_memory, *simd_memory;
    size_t arrays_bytes, bvh_bytes, view_bytes, simd_bytes;
    struct lights lights;
};

/* Sets up the scene at the time of frame 0 and applies the keys; `film` is all zero except `job`. A negative status on
 * failure; after TIA_ERR_RANGE `why` has the reason. */
int film_scene_begin(struct film_scene *film, const struct options *options, char *why);

/* Updates scene and view to frame number `frame`. */
int film_scene_update(struct film_scene *film, uint32_t frame);

/* Frees the scene; safe after a failure. */
void film_scene_end(struct film_scene *film);

#endif
