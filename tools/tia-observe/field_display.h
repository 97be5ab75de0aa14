/* field_display.h - the directions of a light-field display: the picture that each column of its screen shows to an
 * eye. */
#ifndef TOOLS_TIA_OBSERVE_FIELD_DISPLAY_H
#define TOOLS_TIA_OBSERVE_FIELD_DISPLAY_H

#include <stdbool.h>
#include <tia/scene.h>

#include "common/modules.h"

/* A position in front of the screen, from its middle, in the scene's unit: to the right, up, towards the observers. */
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

/* Returns the position where the ray from the eye through a point of the screen, a part of its width from the left,
 * crosses the observer line's plane: 0 at the line's left end, 1 at its right end, less or more beyond them. */
double display_part(const struct display *display, const struct eye *eye, double point);

/* Returns the picture that column `column` of `columns` shows to an eye; -1: the column is black. For views, it is the
 * picture whose eye is nearest to the point where the ray from the eye through the column's middle crosses the observer
 * line's plane; for modules, that of the module nearest to the ray's origin behind the screen; halfway between two, the
 * right one. If that module's light misses the line but the eye's ray does not, it is the picture of the adjacent
 * module, whose light reaches the line. The eye's height makes no difference: there is horizontal parallax only. */
int display_picture(const struct display *display, const struct eye *eye, unsigned column, unsigned columns);

#endif
