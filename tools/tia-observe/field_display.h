/* field_display.h - the directions of a light-field display: the picture that each column of its screen shows to an
 * eye. */
#ifndef TOOLS_TIA_OBSERVE_FIELD_DISPLAY_H
#define TOOLS_TIA_OBSERVE_FIELD_DISPLAY_H

#include <stdbool.h>
#include <tia/scene.h>

#include "common/modules.h"

/* A position relative to the screen's middle, in the scene's unit: x to the right, y up, z towards the observers. */
struct eye {
    double x, y, z;
};

struct display {
    double unit;                    /* the scene's unit, to which lengths are rounded */
    double width, height, distance; /* size of the screen; distance of the observer line from it */
    double from, to;                /* positions of the line's ends */
    unsigned count;                 /* number of pictures */
    bool projects;                  /* the pictures are those of modules */
    double spacing, behind;         /* spacing of modules; their distance behind the screen */
};

/* Prepares the views of a scene with an observer line, or its modules if `modules` is not NULL. */
void display_init(struct display *display, const struct tia_scene *scene, unsigned views,
                  const struct modules *modules);

/* Returns the position at which the ray from the eye through a point of the screen crosses the observer line's plane: 0
 * at the line's left end, 1 at its right end, less or more beyond them. `point` is a fraction of the screen's width,
 * from the left. */
double display_part(const struct display *display, const struct eye *eye, double point);

/* Returns the picture that column `column` of `columns` shows to an eye; -1 if the column is black. The ray from the
 * eye through the column's middle decides. For views, it is the picture of the view nearest to the point where the ray
 * crosses the observer line's plane. For modules, it is the picture of the module nearest to the ray's origin behind
 * the screen. Halfway between two, it is the one further to the right. If the light of that module misses the line but
 * the eye's ray does not, it is the picture of the adjacent module, whose light reaches the line. The eye's height
 * makes no difference: there is horizontal parallax only. */
int display_picture(const struct display *display, const struct eye *eye, unsigned column, unsigned columns);

#endif
