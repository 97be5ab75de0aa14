/* rotation.h - rotations, in integers, whatever the arithmetic. */
#ifndef TIA_SRC_TURN_H
#define TIA_SRC_TURN_H

#include <tia/vec.h>

/* Of any angle in degrees, Q2.62: each within 2^-59, symmetric (sin -x = -sin x, cos -x = cos x, sin x = cos
 * (90 - x), ...), and exact at every multiple of 90 degrees. */
void tia_sincos(tia_q16 degrees, int64_t *sine, int64_t *cosine);

/* Where the axes x, y and z, axes[0] to axes[2], point after the rotation by rotation.x about x, then
 * rotation.y about y, then rotation.z about z: Q2.62, each component within 2^-57. */
void tia_rotation_axes(struct tia_vec3 rotation, int64_t axes[3][3]);

#endif
