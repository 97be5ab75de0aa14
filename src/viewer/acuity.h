/* acuity.h - the size of blocks by their distance from the gaze, see tia/gaze.h. */
#ifndef TIA_VIEWER_ACUITY_H
#define TIA_VIEWER_ACUITY_H

#include <tia/gaze.h>

#define ACUITY_LEVELS 4 /* blocks of 2, 4, 8, 16 */

/* Constants of a picture. */
struct tia_acuity {
    unsigned width, height;
    uint32_t distance;               /* distance of the eye from the picture, half pixels: at most 2^20 */
    int32_t gaze[3];                 /* direction of the gaze, Q2.30 */
    uint32_t cosine2[ACUITY_LEVELS]; /* squared cosine, Q0.20, of the angle from which blocks of 2, 4, 8, 16 suffice */
    unsigned levels;                 /* number of these sizes that suffice anywhere */
};

/* Prepares the acuity for a picture of width x height pixels (1..8192 each). False when every pixel is to be drawn, and
 * when a size or view_angle is out of range. */
bool tia_acuity_init(struct tia_acuity *acuity, const struct tia_gaze *gaze, unsigned width, unsigned height);

/* Returns the block size at a pixel: 1, 2, 4, 8 or 16; 1 outside the picture. */
unsigned tia_acuity_block(const struct tia_acuity *acuity, unsigned x, unsigned y);

#endif
