/* rotation.h - rotations in integers, the same for all arithmetics. */
#ifndef TIA_MATH_ROTATION_H
#define TIA_MATH_ROTATION_H

#include <tia/vec.h>

/* Gives sine and cosine of any angle in degrees, Q2.62, within 2^-59. Exact at multiples of 90 degrees, and exactly
 * symmetric: sin -x = -sin x, cos -x = cos x, sin x = cos(90 - x), ... */
void tia_sincos(tia_q16 degrees, int64_t *sine, int64_t *cosine);

/* Gives the columns of the rotation matrix: axes[0], axes[1] and axes[2] are the x, y and z axes after rotation by
 * rotation.x degrees about x, then rotation.y about y, then rotation.z about z. Q2.62, each component within 2^-57. */
void tia_rotation_axes(struct tia_vec3 rotation, int64_t axes[3][3]);

/* Gives the angles of a rotation with these axes, rounded to nearest: about x and z in -180..180 degrees, about y in
 * -90..90. If the angle about y is +-90 degrees, the angle about z is 0. */
void tia_rotation_angles(const int64_t axes[3][3], struct tia_vec3 *rotation);

#endif
