/* trig.h - sine, cosine and cotangent in integers. */
#ifndef TIA_MATH_TRIG_H
#define TIA_MATH_TRIG_H

#include <stdint.h>
#include <tia/camera.h>

/* Gives sine and cosine of an angle of 0..45 degrees, given in units of 2^-17 degrees (0..90 * 2^16): Q1.63, within
 * 2^-59; exact for 0. */
void tia_octant(uint32_t half_degrees, uint64_t *sine, uint64_t *cosine);

/* Returns cot(fov / 2) for a field of view of TIA_FOV_MIN..TIA_FOV_MAX degrees: unsigned Q8.56, relative error below
 * 2^-50. */
uint64_t tia_cotangent(tia_q16 fov);

#endif
