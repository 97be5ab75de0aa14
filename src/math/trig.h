/* trig.h - the trigonometry under every other, in integers. */
#ifndef TIA_SRC_ANGLE_H
#define TIA_SRC_ANGLE_H

#include <stdint.h>
#include <tia/camera.h>

/* Sine and cosine of 0..45 degrees, given in units of 2^-17 degrees (0..90 * 2^16): Q1.63, within 2^-59;
 * of 0 exactly. */
void tia_octant(uint32_t half_degrees, uint64_t *sine, uint64_t *cosine);

/* cot(fov / 2) for a field of view of TIA_FOV_MIN..TIA_FOV_MAX degrees: unsigned Q8.56, within
 * 2^-50 of it, relative. */
uint64_t tia_cotangent(tia_q16 fov);

#endif
