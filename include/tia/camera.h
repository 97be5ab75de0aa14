/* camera.h - where the picture is seen from.
 *
 * The camera looks along -z with +y up. The ray through the centre of pixel (x, y) of a
 * width x height image leaves the eye along
 *
 *     ((2(x + 0.5)/width - 1) a width/height, (1 - 2(y + 0.5)/height) a, -1),   a = tan(fov/2).
 *
 * tia keeps that direction unnormalised, multiplied by height/a: (2x+1-width, height-2y-1, -height/a)
 * is a lattice of integers in x and y, and every product with it is exact.
 */
#ifndef TIA_CAMERA_H
#define TIA_CAMERA_H

#include <tia/vec.h>

#define TIA_FOV_MIN TIA_Q16(1) /* degrees */
#define TIA_FOV_MAX TIA_Q16(170)

struct tia_camera {
    struct tia_vec3 eye;
    tia_q16 fov; /* vertical field of view, degrees, TIA_FOV_MIN..TIA_FOV_MAX */
};

#endif
