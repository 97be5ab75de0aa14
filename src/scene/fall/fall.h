/* fall.h - positions of falling balls at any time. */
#ifndef TIA_SCENE_FALL_FALL_H
#define TIA_SCENE_FALL_FALL_H

#include <tia/motion.h>

struct cancel;

/* Returns the bytes of memory that tia_fall_at needs, for a scene whose `falling` is not NULL. */
uint64_t tia_fall_size(const struct tia_scene *scene);

/* Sets the positions of the balls' transforms, and hides the shapes that are lost. The arrays hold the scene's elements
 * at that time. It may be cancelled halfway. */
void tia_fall_at(const struct tia_scene *scene, void *memory, tia_q16 time, struct tia_transform *transforms,
                 struct tia_shape *shapes, struct cancel *cancel);

/* Makes a shape an instance of the scene's last mesh, which has no faces. */
void tia_fall_hide(const struct tia_scene *scene, struct tia_shape *shape);

#endif
