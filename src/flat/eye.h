/* eye.h - the camera's matrix in integers, from points of the world to vertices for the rasteriser. */
#ifndef TIA_FLAT_EYE_H
#define TIA_FLAT_EYE_H

#include <tia/raster.h>
#include <tia/scene.h>

/* A row of the matrix: m[i] 2^-places for each axis i of the world, plus offset 2^-offset_places for points. */
struct tia_eye_row {
    int64_t m[3], offset; /* below 2^62 in magnitude */
    int places, offset_places;
};

/* The matrix. Its rows give x, y and w of raster.h, in orthographic views x, y and h. */
struct tia_eye {
    enum tia_projection projection;
    int64_t origin[3]; /* position of the eye, Q31.32 */
    struct tia_eye_row row[3];
};

/* Sets the eye for the camera of a scene that tia_scene_check accepts, with its fine digits. The positions of samples
 * in a pixel are part of the rasteriser's grid instead. */
void tia_eye_init(struct tia_eye *eye, const struct tia_scene *scene, unsigned width, unsigned height);

/* Returns the smallest r, at least 0, for which the coordinates of a point's vertex are below 2^r in magnitude. Points
 * are Q31.32 and less than 2^17 from the eye in each coordinate. */
unsigned tia_eye_range(const struct tia_eye *eye, const int64_t point[3]);

/* Gives the vertex of a point, whose tia_eye_range is at most TIA_RANGE_MAX; each coordinate is rounded once, to
 * `fraction` fraction bits, 0..40.
 */
void tia_eye_point(const struct tia_eye *eye, const int64_t point[3], int fraction, struct tia_raster_vertex *vertex);

/* Gives the vertex at infinity in a direction, Q1.62, of length about 1. The vertex has the same direction; its largest
 * coordinate is just below 2^bits, bits in 8..40. */
void tia_eye_direction(const struct tia_eye *eye, const int64_t direction[3], int bits,
                       struct tia_raster_vertex *vertex);

/* Gives the axes A and B of light.h for a normal of length 1; all are Q1.62. */
void tia_eye_across(const int64_t normal[3], int64_t across[2][3]);

/* Gives the direction at an angle, in degrees, from a towards b. Directions are Q1.62; a and b are at right angles. */
void tia_eye_around(const int64_t a[3], const int64_t b[3], tia_q16 angle, int64_t direction[3]);

#endif
