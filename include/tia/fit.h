/* fit.h - a camera that is changed, or that sees a whole scene, in integers. */
#ifndef TIA_FIT_H
#define TIA_FIT_H

#include <tia/read.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Changes a camera as tia_read does. A camera that looks along -z stays so with another eye; with a reference point and
 * no up vector, +y becomes its up vector, and with an up vector alone it gets a reference point ahead. One with an
 * observer line keeps its projection. Positions beyond Q16.16 are clamped. tia_scene_check may refuse the result. */
void tia_camera_alter(struct tia_camera *camera, const struct tia_camera_change *change,
                      const struct tia_placement *placement);

/* A place for the eye: Q47.16, so that it can be beyond the range of a scene's unit. */
struct tia_fit {
    int64_t eye[3], reference[3];
    int64_t height; /* of the window of an orthographic camera; otherwise 0 */
};

/* Finds the place from which a camera that looks as scene->camera does has all of the scene in a picture of width x
 * height pixels: the boxes of all objects fit tightly, with a margin of a 64th of it on each side. Planes and lights do
 * not count. A scene with a hierarchy takes less time and the boxes of its leaves. TIA_ERR_RANGE if there is no object
 * with a box, or no such place within 2^24 units. The scene is one that tia_scene_check accepts. */
int tia_camera_fit(struct tia_fit *fit, const struct tia_scene *scene, unsigned width, unsigned height);

#ifdef __cplusplus
}
#endif

#endif
