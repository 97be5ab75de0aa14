/* radio.h - finds paths of radio waves in double precision, by the mirror images for every sequence of polygons. */
#ifndef TESTS_ORACLE_RADIO_H
#define TESTS_ORACLE_RADIO_H

#include <stdbool.h>

#define ORACLE_ORDER 3

struct oracle_polygon {
    double corner[4][3];
    int count;
    bool solid; /* only the side from which the corners appear counterclockwise reflects */
};

struct oracle_path {
    int order;
    double point[ORACLE_ORDER][3];
    double length;
    bool sure; /* no comparison was closer than `doubt` */
};

/* Finds the paths of up to `order` reflections, including those that are paths only if comparisons are off by less than
 * `doubt`. Returns their number; at most `most` are written. */
int oracle_radio(const struct oracle_polygon *polygons, int count, const double from[3], const double to[3], int order,
                 double doubt, struct oracle_path *paths, int most);

#endif
