/* fall.h - positions of falling balls at any time. */
#ifndef TIA_SCENE_FALL_FALL_H
#define TIA_SCENE_FALL_FALL_H

#include <tia/motion.h>

struct cancel;
struct falling;

/* Returns the number of bytes of memory that tia_fall_at needs; the scene's `falling` must not be NULL. */
uint64_t tia_fall_size(const struct tia_scene *scene);

/* Sets balls to the beginning, in memory of tia_fall_size bytes. f->cancel must be set. */
void tia_fall_begin(struct falling *f, const struct tia_scene *scene, void *memory);

/* Moves the balls through tick number `tick`, at whose beginning they are, or as much of it as is before `until`,
 * Q16.16 s. */
void tia_fall_to(struct falling *f, uint32_t tick, uint32_t until);

/* Sets the positions of the balls' transforms, and hides the balls that are lost. */
void tia_fall_put(const struct falling *f, const struct tia_scene *scene, struct tia_transform *transforms,
                  struct tia_shape *shapes);

/* Sets the positions of the balls' transforms at `time`, and hides the balls that are lost. The arrays hold the scene's
 * elements at that time. Once cancelled, the positions are undefined. */
void tia_fall_at(const struct tia_scene *scene, void *memory, tia_q16 time, struct tia_transform *transforms,
                 struct tia_shape *shapes, struct cancel *cancel);

/* Hides a shape: makes it an instance of the scene's last mesh, which has no faces. */
void tia_fall_hide(const struct tia_scene *scene, struct tia_shape *shape);

#endif
