/* fall.h - positions of falling balls at any time. */
#ifndef TIA_SCENE_FALL_FALL_H
#define TIA_SCENE_FALL_FALL_H

#include <tia/motion.h>

struct cancel;

/* Returns the number of bytes of memory that tia_fall_at needs; the scene's `falling` must not be NULL. */
uint64_t tia_fall_size(const struct tia_scene *scene);

/* Sets the positions of the balls' transforms at `time`, and hides the balls that are lost. The arrays hold the scene's
 * elements at that time. Once cancelled, the positions are undefined. */
void tia_fall_at(const struct tia_scene *scene, void *memory, tia_q16 time, struct tia_transform *transforms,
                 struct tia_shape *shapes, struct cancel *cancel);

/* Hides a shape: makes it an instance of the scene's last mesh, which has no faces. */
void tia_fall_hide(const struct tia_scene *scene, struct tia_shape *shape);

#endif
