/* radio.h - paths of waves in double precision: every sequence of polygons, mirrored and walked back. */
#ifndef TESTS_ORACLE_RADIO_H
#define TESTS_ORACLE_RADIO_H

#include <stdbool.h>

#define ORACLE_ORDER 3

struct oracle_polygon {
    double corner[4][3];
    int count;
    bool solid; /* only the outside reflects, where the corners run counterclockwise */
};

struct oracle_path {
    int order;
    double point[ORACLE_ORDER][3];
    double length;
    bool sure; /* no decision was closer than `doubt` */
};

/* Finds all paths of up to `order` reflections, and all that may be one if decisions are wrong by less than `doubt`.
 * Returns their number, of which `most` are written. */
int oracle_radio(const struct oracle_polygon *polygons, int count, const double from[3], const double to[3], int order,
                 double doubt, struct oracle_path *paths, int most);

#endif
