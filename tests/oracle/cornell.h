/* cornell.h - the Cornell box of scenes/cornell.tia, its light followed along random paths in double precision: with
 * other intersections, other random numbers, other directions, and no balance heuristic. */
#ifndef TESTS_ORACLE_CORNELL_H
#define TESTS_ORACLE_CORNELL_H

#include <stdint.h>

/* Adds the mean radiance of rows^2 samples to each pixel of a square picture, three numbers a pixel. Other seeds give
 * independent samples. */
void oracle_box(unsigned side, uint64_t seed, unsigned rows, double *rgb);

/* The reflectances of white, red and green, and the lamp's radiance, from the spectra of Cornell's page of data. */
extern const double oracle_box_colours[4][3];

/* The four corners of each polygon, in the page's order. */
extern const double oracle_box_polygons[15][4][3];

/* The lamp: two opposite corners. */
extern const double oracle_box_lamp[2][3];

#endif
