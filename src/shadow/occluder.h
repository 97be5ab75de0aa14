/* occluder.h - exact test whether a face hides a light from a visible point, by the signs of integers.
 *
 * In every projection, a pixel with the direction D shows the point (D, s), s = N.D/d, of a plane N.(x, y, w) = d h,
 * see raster.h. The side of another plane M.(x, y, w) = m h on which the point lies is the sign of
 *
 *     M.D - m s,   which for d > 0 has the sign of   (M.D) d - m (N.D).
 *
 * A face hides the light when the point is on one side of all planes through the light and an edge of the face, and
 * beyond the face's own plane. Where a sign is 0, D is moved as the rasteriser moves it, to the right, then down; a
 * face in the visible face's own plane does not hide the light. The sides of shadow volumes lie in the same planes, and
 * their depths are compared by the same integers, so both techniques give the same shadows, and neither needs a bias.
 *
 * The products have up to 243 bits. A filter decides most cases first: there s has a relative error below 2^-58 and m
 * one below 2^-61; M.D, in a unit in which it is below 2^62, is less than 2^14 too small. shadow_ranges.h has the
 * resulting error of M.D - m s, and tests/proofs/shadow_occluder.g proves it. */
#ifndef TIA_SHADOW_OCCLUDER_H
#define TIA_SHADOW_OCCLUDER_H

#include "flat/light_vertices.h"

/* The plane of a visible face. */
struct tia_seen_face {
    const struct tia_raster_plane *plane;
    uint32_t face;
    int64_t reciprocal; /* 1/d 2^(62 + bits) */
    int bits;           /* number of bits of d */
};

/* The visible point of pixel (x, y): s is nearness 2^exponent. */
struct tia_seen {
    const struct tia_seen_face *of;
    int x, y;
    int64_t nearness;
    int exponent;
};

/* A plane for the filter: at pixel (i, j) M.D is (x i + y j + c) 2^unit, and the plane's m is m 2^m_unit. Differences
 * of up to `unsure` are undecided. */
struct tia_occluder_plane {
    int64_t x, y, c, m;
    int32_t unsure;
    int16_t unit, m_unit;
};

/* A face in front of a light. */
struct tia_occluder {
    const struct tia_flat_scene *flat;
    const tia_flat_light *light;
    uint32_t face;
    uint32_t flush; /* last face found to lie in the same plane, or TIA_NO_FACE */
    unsigned sides;
    int side;       /* the hidden points are on this side of all planes, 1 or -1; 0: no point is hidden */
    unsigned ready; /* number of planes that are prepared, as most faces need few */
    struct tia_occluder_plane plane[TIA_SIDES + 1]; /* the face's own plane, then those through its edges */
};

/* Prepares a face that is visible at some pixel. */
void tia_seen_face_init(struct tia_seen_face *of, const struct tia_flat_scene *flat, uint32_t face);

/* Prepares a pixel that shows the face. */
void tia_seen_init(struct tia_seen *seen, const struct tia_seen_face *of, int x, int y);

/* Prepares an occluder, which keeps pointers to `flat` and `light`; false when the light is in the face's plane, so
 * that the face hides no point. */
bool tia_occluder_init(struct tia_occluder *occluder, const struct tia_flat_scene *flat, const tia_flat_light *light,
                       uint32_t face);

/* Prepares plane k, if it is not. All planes below k must be prepared. */
void tia_occluder_ready(struct tia_occluder *occluder, unsigned k);

/* True if the face hides the light from the pixel's visible point; a face never hides the light from itself. The
 * visible face must be turned to the light. */
bool tia_occluder_hides(struct tia_occluder *occluder, const struct tia_seen *seen);

#endif
