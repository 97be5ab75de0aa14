/* cornell.h - draws the Cornell box of scenes/cornell.tia by random paths in double precision. Intersections, random
 * numbers and directions are computed otherwise than in the library, and there is no balance heuristic. */
#ifndef TESTS_ORACLE_CORNELL_H
#define TESTS_ORACLE_CORNELL_H

#include <stdint.h>

/* Adds the mean radiance of rows^2 samples to each pixel of a square picture, three numbers a pixel. Different seeds
 * give independent samples. */
void oracle_box(unsigned side, uint64_t seed, unsigned rows, double *rgb);

/* Reflectances of white, red and green, and the lamp's radiance, from the spectra on Cornell's page of data. */
extern const double oracle_box_colours[4][3];

/* Corners of the polygons, in the order of Cornell's page. */
extern const double oracle_box_polygons[15][4][3];

/* Two opposite corners of the lamp. */
extern const double oracle_box_lamp[2][3];

#endif
