/* direction.h - directions around the z axis from numbers of sobol.h, in integers: unit vectors, Q1.62.
 *
 * Densities are per solid angle; t is the angle to the axis. Error bounds are distances from the exact vector, as
 * measured by tests/test_sampling.c. */
#ifndef TIA_SAMPLES_DIRECTION_H
#define TIA_SAMPLES_DIRECTION_H

#include <tia/fixed.h>

/* Writes the sine and cosine of (u + 1/2)/2^32 turns, Q1.62, within 2^-60. */
void tia_sample_turn(uint32_t u, int64_t *sine, int64_t *cosine);

/* Writes a direction with the density cos t/pi, t below 90 degrees: the concentric map (Shirley and Chiu 1997) of the
 * square to the disc, lifted to the hemisphere. The error is below 2^-59. */
void tia_sample_cosine(const uint32_t u[2], int64_t direction[3]);

/* Writes a direction with the density (n + 1)/(2 pi) cos^n t, n = 1..TIA_EXPONENT_MAX: Phong's lobe. The error is below
 * 2^-36. */
void tia_sample_phong(const uint32_t u[2], tia_q16 exponent, int64_t direction[3]);

/* Writes a uniformly distributed point (x, y) of the unit disc, Q1.62, within 2^-60. */
void tia_sample_disc(const uint32_t u[2], int64_t place[2]);

#endif
