/* motion.h - a moving scene at a time, with balls that have been moved already. */
#ifndef TIA_SCENE_MOTION_H
#define TIA_SCENE_MOTION_H

#include <tia/motion.h>

struct falling;

/* Does the work of tia_scene_at. The balls are where `at` has them; NULL: where they fall from the beginning. */
int tia_motion_at(struct tia_scene *out, void *memory, size_t size, const struct tia_scene *scene, tia_q16 time,
                  const struct falling *at, const struct tia_job *job);

#endif
