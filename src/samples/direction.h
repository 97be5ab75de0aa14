/* direction.h - numbers of sobol.h as directions around the z axis, in integers: unit vectors, Q1.62.
 *
 * `density` is over solid angles; t is the angle to the axis. Errors are largest distances from the exact vector;
 * tests/test_sampling.c measures them. */
#ifndef TIA_SAMPLES_DIRECTION_H
#define TIA_SAMPLES_DIRECTION_H

#include <tia/fixed.h>

/* Gives sine and cosine of (u + 1/2)/2^32 turns, within 2^-60. */
void tia_sample_turn(uint32_t u, int64_t *sine, int64_t *cosine);

/* Gives a direction with the density cos t/pi, t below 90 degrees: the concentric map (Shirley and Chiu 1997) of the
 * square to the disc, lifted. Within 2^-59. */
void tia_sample_cosine(const uint32_t u[2], int64_t direction[3]);

/* Gives a direction with the density (n + 1)/(2 pi) cos^n t, n = 1..TIA_EXPONENT_MAX: Phong's lobe. Within 2^-36. */
void tia_sample_phong(const uint32_t u[2], tia_q16 exponent, int64_t direction[3]);

/* Gives a uniformly distributed point of the unit disc: x, y. Within 2^-60. */
void tia_sample_disc(const uint32_t u[2], int64_t place[2]);

#endif
