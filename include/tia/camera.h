/* camera.h - the camera: projection, position and samples per pixel.
 *
 * The ray through the centre of pixel (x, y) of a width x height image leaves the eye along
 *
 *     ((2(x + 0.5)/width - 1) a width/height, (1 - 2(y + 0.5)/height) a, -1),   a = tan(fov/2),
 *
 * in the camera's axes u, v, n. When `up` is (0, 0, 0) those are x, y and z: the camera looks along -z, and
 * +y is up. Otherwise it looks from the eye E at the reference point R with the up vector V, like gluLookAt:
 *
 *     n = (E - R)/|E - R|,   u = V x n normalised,   v = n x u.
 *
 * An off-axis frustum (TIA_FRUSTUM, like glFrustum) maps the window left..right, bottom..top at the distance `near` to
 * the whole image. The rays of an orthographic camera (TIA_ORTHOGRAPHIC, like glOrtho) start in that window around the
 * eye and all run along -n. A window with left = right = 0 is centred, and its width follows from the image's aspect
 * ratio, up to 65536.
 *
 * A frustum camera can have an observer line, along u and centred on the eye. Its window is then a display's flat
 * screen. The camera's own picture is that of the eye in the middle; for the other eyes see lightfield.h.
 *
 * With n x n samples per pixel, sample i + n j goes through (x + (i + (j + 1/2)/n)/n, y + (j + (n - i - 1/2)/n)/n): no
 * two samples of a pixel share their x or their y. Each sample's colour is clamped; the pixel is their mean.
 *
 * The span renderer (see scene.h) leaves directions unnormalised and scales them by height/a, so that a direction
 * (2x+1-width, height-2y-1, -height/a) has integer x and y components, and differs from the next pixel's by a constant.
 */
#ifndef TIA_CAMERA_H
#define TIA_CAMERA_H

#include <tia/vec.h>

#ifdef __cplusplus
extern "C" {
#endif

#define TIA_FOV_MIN TIA_Q16(1) /* degrees */
#define TIA_FOV_MAX TIA_Q16(170)
#define TIA_SAMPLES_MAX 16

enum tia_projection { TIA_PERSPECTIVE, TIA_FRUSTUM, TIA_ORTHOGRAPHIC };

struct tia_window {
    tia_q16 left, right, bottom, top; /* edges along u and v, lengths from the eye: bottom < top; left < right, or both
                                         0. The corners of an orthographic window lie within 32768 of the eye. */
    tia_q16 near;                     /* TIA_FRUSTUM only: the window's distance from the eye, above 0 */
};

struct tia_camera {
    struct tia_vec3 eye;
    tia_q16 fov; /* TIA_PERSPECTIVE only: vertical field of view, degrees, TIA_FOV_MIN..TIA_FOV_MAX */
    enum tia_projection projection;
    struct tia_vec3 reference; /* target of the camera: within 32768 of the eye, and not the eye itself */
    struct tia_vec3 up;        /* at least 0.056 degrees (a sine of 2^-10) off the line of sight;
                                  (0, 0, 0): the camera looks along -z */
    struct tia_window window;  /* TIA_FRUSTUM and TIA_ORTHOGRAPHIC only */
    uint32_t samples;          /* per pixel: 1, 4 or 16; 0 means 1 */
    tia_q16 line; /* TIA_FRUSTUM only: half the length of the observer line; 0: no line. Along u, the window must lie
                     within 32768 of all eyes on the line. */
};

/* A thin lens instead of a pinhole: each sample's ray starts at a random point of a disc around the eye, across the
 * line of sight, and goes to the point where the pinhole's ray meets the plane in focus. A point at the distance d from
 * the plane of the lens so becomes a disc of radius * |1 - focus/d| on the plane in focus. The points of the disc are
 * Owen-scrambled Sobol points of the pixel and sample. Not for light fields. */
struct tia_lens {
    tia_q16 radius; /* of the lens: half of its aperture; above 0, at most `focus` */
    tia_q16 focus;  /* distance of the plane in focus from the eye, along the line of sight, at least 2^-10 */
};

#ifdef __cplusplus
}
#endif

#endif
