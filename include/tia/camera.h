/* camera.h - where the picture is seen from.
 *
 * The ray through the centre of pixel (x, y) of a width x height image leaves the eye along
 *
 *     ((2(x + 0.5)/width - 1) a width/height, (1 - 2(y + 0.5)/height) a, -1),   a = tan(fov/2),
 *
 * in the camera's axes u, v, n. Those are x, y and z - the camera looks along -z, +y is up - when
 * `up` is (0, 0, 0). Else the camera looks from the eye E at the reference point R with the up vector V:
 *
 *     n = (E - R)/|E - R|,   u = V x n normalised,   v = n x u.
 *
 * An off-axis frustum (TIA_FRUSTUM) maps the window left..right, bottom..top at the distance `near`
 * to the whole image; an orthographic camera's rays (TIA_ORTHOGRAPHIC) start in that window around the
 * eye and all run along -n. A window with left = right = 0 is centred and takes its width from the
 * image's proportions, but is at most 65536 wide.
 *
 * With n x n samples a pixel, sample i + n j goes through (x + (i + (j + 1/2)/n)/n, y + (j + (n - i - 1/2)/n)/n),
 * so that no two share a row or column; each one's colour is clamped, and the pixel is their mean.
 *
 * Where nothing else asks for general rays, the direction stays unnormalised, multiplied by height/a:
 * (2x+1-width, height-2y-1, -height/a) is a lattice of integers in x and y.
 */
#ifndef TIA_CAMERA_H
#define TIA_CAMERA_H

#include <tia/vec.h>

#define TIA_FOV_MIN TIA_Q16(1) /* degrees */
#define TIA_FOV_MAX TIA_Q16(170)
#define TIA_SAMPLES_MAX 16

enum tia_projection { TIA_PERSPECTIVE, TIA_FRUSTUM, TIA_ORTHOGRAPHIC };

struct tia_window {
    tia_q16 left, right, bottom, top; /* bottom < top; left < right, or both 0 */
    tia_q16 near;                     /* of a frustum, above 0 */
    /* An orthographic window's corners are nearer to the eye than 32768. */
};

struct tia_camera {
    struct tia_vec3 eye;
    tia_q16 fov; /* vertical field of view, degrees, TIA_FOV_MIN..TIA_FOV_MAX; of TIA_PERSPECTIVE only */
    enum tia_projection projection;
    struct tia_vec3 reference; /* the point looked at; nearer than 32768, and not the eye */
    struct tia_vec3 up;        /* its angle with the line of sight has a sine of 2^-10 (0.056 degrees) or more;
                                  (0, 0, 0): the camera looks along -z */
    struct tia_window window;  /* of TIA_FRUSTUM and TIA_ORTHOGRAPHIC */
    uint32_t samples;          /* rays a pixel: 1, 4 or 16; 0: 1 */
};

#endif
