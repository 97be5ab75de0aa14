/* moment.h - a scene that plays, at one time. */
#ifndef TOOLS_COMMON_SCENE_MOMENT_H
#define TOOLS_COMMON_SCENE_MOMENT_H

#include <tia/scene.h>

/* The memory of such a scene; all zero at first. */
struct moment {
    void *arrays, *boxes;
};

/* Replaces *scene, if it moves, by the scene at `time` (seconds), with a hierarchy of its own. It shares what does not
 * move with the scene that was there, and is valid until moment_end. Returns the status of tia_scene_at or
 * tia_bvh_move; moment_end is needed after an error too. */
int moment_begin(struct moment *moment, struct tia_scene *scene, tia_q16 time);
void moment_end(struct moment *moment);

#endif
