/* angle.h - the one trigonometric function that the core needs, in integers. */
#ifndef TIA_SRC_ANGLE_H
#define TIA_SRC_ANGLE_H

#include <stdint.h>
#include <tia/camera.h>

/* cot(fov / 2) for a field of view of TIA_FOV_MIN..TIA_FOV_MAX degrees: unsigned Q8.56, within
 * 2^-50 of it, relative. */
uint64_t tia_cotangent(tia_q16 fov);

#endif
