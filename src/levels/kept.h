/* kept.h - a run's bounds, kept for those of the next rows. */
#ifndef TIA_LEVELS_KEPT_H
#define TIA_LEVELS_KEPT_H

#include "prepare.h"

/* What bounds depend on from row to row, each so that more is worse. */
#define LEVEL_LIMITS 16

struct level_kept {
    bool known;
    uint32_t sphere;
    int limits;
    double limit[LEVEL_LIMITS];
    struct level_depth depth;
    double near31, near63;
    struct level_bounds light[LEVEL_LIGHTS];
    struct level_cast_bounds cast[LEVEL_LIMITS / 2];
};

/* The bounds for an arithmetic; false when they are too large. `kept` may be NULL. Else it belongs to this arithmetic,
 * and the bounds may be those of an earlier run that was as bad or worse. */
bool tia_level_fine_bounds(struct level_fine *fine, double unit, double cut, struct level_kept *kept);

/* Bounds for each half of the picture and some spheres, in both arithmetics. */
#define LEVEL_SHELVES 8

struct level_shelf {
    struct level_kept single, fine;
};

static inline struct level_shelf *level_shelf_of(struct level_shelf *shelves, const struct level_fine *fine)
{
    unsigned right = fine->place.middle > fine->view->width / 2;

    return &shelves[(2 * fine->sphere + right) % LEVEL_SHELVES];
}

#endif
