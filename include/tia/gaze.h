/* gaze.h - pictures whose detail falls with the distance from the gaze, by the acuity model of Guenter et al.,
 * "Foveated 3D Graphics" (2012). Two points that are e degrees off the gaze look separate if they are at least
 *
 *     MAR(e) = w0 + m e
 *
 * degrees apart, the minimum angle of resolution. So only one pixel of each block is drawn, its upper left corner.
 * Blocks are 1, 2, 4, 8 or 16 pixels wide: the largest width that is at most MAR. Within TIA_FOVEA of the gaze every
 * pixel is drawn; e is clamped to 90. All pixels are assumed to look as large as the one in the middle of the picture.
 * Pixels towards the edges look smaller, so blocks there are never too large.
 *
 * The eye is in front of the middle of the picture, at the distance where the picture is `view_angle` wide.
 */
#ifndef TIA_GAZE_H
#define TIA_GAZE_H

#include <tia/fixed.h>

#ifdef __cplusplus
extern "C" {
#endif

#define TIA_FOVEA TIA_Q16(2.5) /* half of the fovea's 5 degrees */
#define TIA_GAZE_W0 349525u    /* 1/48 degree, Q8.24 */
#define TIA_GAZE_M 461373u     /* 0.0275 degrees per degree, Q8.24 */
#define TIA_GAZE_BLOCK 16      /* width of the largest block, pixels */

struct tia_gaze {
    uint16_t x, y;      /* the pixel that is looked at; if it is outside the picture, every pixel is drawn */
    tia_q16 view_angle; /* degrees, TIA_Q16(1)..TIA_Q16(170); 0: every pixel is drawn */
    uint32_t w0, m;     /* degrees, and degrees per degree: Q8.24, below 2^31 */
    bool smooth;        /* interpolate between drawn pixels instead of repeating them */
};

#ifdef __cplusplus
}
#endif

#endif
