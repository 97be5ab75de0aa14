/* acuity.c - the largest blocks that the eye cannot distinguish from the pixels that they replace. */
#include "acuity.h"

#include <tia/render.h>

#include "math/integer.h"
#include "math/trig.h"

#define VIEW_LEAST TIA_Q16(1)
#define VIEW_MOST TIA_Q16(170)
#define RIGHT_ANGLE TIA_Q16(90)

/* Angle of a pixel in the middle of the picture, degrees in Q8.24, times the distance in half pixels. A pixel is two
 * half pixels, and a small angle nearly equals its tangent: 2 * 180 / pi * 2^24. */
#define PIXEL_ANGLE UINT32_C(1922527338)

/* Returns cos^2 of 0..90 degrees, Q16.16, as Q0.20, rounded to nearest. */
static uint32_t cosine_squared(uint32_t degrees)
{
    const uint32_t right_angle = RIGHT_ANGLE;
    uint64_t sine, cosine, high;
    bool above = degrees > right_angle / 2;

    tia_octant(2 * (above ? right_angle - degrees : degrees), &sine, &cosine);
    high = (above ? sine : cosine) >> 32; /* Q1.31, its square Q2.62 */
    return (uint32_t)((high * high + (UINT64_C(1) << 41)) >> 42);
}

/* Returns the smallest e in degrees, Q16.16, for which w0 + m e is at least `angle`, Q8.24: (angle - w0) / m, rounded
 * up, but at least TIA_FOVEA. Returns UINT64_MAX if there is none. angle < 2^36, so the quotient is below 2^52 / m +
 * 1. */
static uint64_t degrees_from(const struct tia_gaze *gaze, uint64_t angle)
{
    uint64_t from = angle > gaze->w0 ? angle - gaze->w0 : 0;

    if (from && !gaze->m)
        return UINT64_MAX;
    if (from)
        from = ((from << 16) + gaze->m - 1) / gaze->m;
    return from > TIA_FOVEA ? from : TIA_FOVEA;
}

static void set_levels(struct tia_acuity *acuity, const struct tia_gaze *gaze)
{
    uint64_t pixel = PIXEL_ANGLE / acuity->distance;

    acuity->levels = 0;
    for (unsigned i = 0; i < ACUITY_LEVELS; i++) {
        uint64_t from = degrees_from(gaze, pixel << (i + 1));
        if (from > RIGHT_ANGLE)
            return;
        acuity->cosine2[i] = cosine_squared((uint32_t)from);
        acuity->levels++;
    }
}

bool tia_acuity_init(struct tia_acuity *acuity, const struct tia_gaze *gaze, unsigned width, unsigned height)
{
    if (!acuity || !gaze || width > TIA_SIZE_MAX || height > TIA_SIZE_MAX || gaze->view_angle < VIEW_LEAST ||
        gaze->view_angle > VIEW_MOST || gaze->x >= width || gaze->y >= height)
        return false;
    /* `width` is also half the width in half pixels; cot(angle / 2) is Q8.56 */
    uint64_t distance = (width * (tia_cotangent(gaze->view_angle) >> 24)) >> 32;
    acuity->width = width;
    acuity->height = height;
    acuity->distance = distance ? (uint32_t)distance : 1;
    struct tia_dir3 g = tia_normalise(2 * (int32_t)gaze->x + 1 - (int32_t)width,
                                      2 * (int32_t)gaze->y + 1 - (int32_t)height, (int32_t)acuity->distance);
    acuity->gaze[0] = g.x;
    acuity->gaze[1] = g.y;
    acuity->gaze[2] = g.z;
    set_levels(acuity, gaze);
    return acuity->levels > 0;
}

/* Returns the block size. e is the angle between the gaze G, of length 1, and the pixel's direction p: cos e = G.p /
 * |p|. It is at least the angle a from which a block size suffices if (G.p)^2 <= cos^2 a |p|^2. With |p| < 2^20.1 and
 * G.p in units of 2^-10, both sides are below 2^61. */
unsigned tia_acuity_block(const struct tia_acuity *acuity, unsigned x, unsigned y)
{
    if (!acuity || x >= acuity->width || y >= acuity->height)
        return 1;
    int64_t px = 2 * (int64_t)x + 1 - (int64_t)acuity->width, py = 2 * (int64_t)y + 1 - (int64_t)acuity->height;
    int64_t distance = (int64_t)acuity->distance,
            dot = acuity->gaze[0] * px + acuity->gaze[1] * py + acuity->gaze[2] * distance;
    uint64_t along = dot > 0 ? ((uint64_t)dot + (UINT64_C(1) << 19)) >> 20 : 0;
    uint64_t square = (uint64_t)(px * px) + (uint64_t)(py * py) + (uint64_t)(distance * distance);
    unsigned level = acuity->levels;

    while (level > 0 && along * along > square * acuity->cosine2[level - 1])
        level--;
    return 1u << level;
}
