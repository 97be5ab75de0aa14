/* fall.h - where balls are that fall, at any time. */
#ifndef TIA_SCENE_FALL_FALL_H
#define TIA_SCENE_FALL_FALL_H

#include <tia/motion.h>

struct cancel;

/* Bytes of memory that tia_fall_at needs, of a scene whose `falling` is not NULL. */
uint64_t tia_fall_size(const struct tia_scene *scene);

/* Sets the positions of the balls' transforms, and hides those of the shapes that got lost. The arrays have what the
 * scene's have, at that time. The cancel may stop it halfway. */
void tia_fall_at(const struct tia_scene *scene, void *memory, tia_q16 time, struct tia_transform *transforms,
                 struct tia_shape *shapes, struct cancel *cancel);

/* Makes a shape an instance of the scene's last mesh, which has no faces. */
void tia_fall_hide(const struct tia_scene *scene, struct tia_shape *shape);

#endif
