/* display.h - what a light-field display sends where: which picture each column of its screen shows an eye. */
#ifndef TOOLS_TIA_OBSERVE_DISPLAY_H
#define TOOLS_TIA_OBSERVE_DISPLAY_H

#include <stdbool.h>
#include <tia/scene.h>

#include "common/modules.h"

/* A place before the screen, from its middle, in the scene's unit: to the right, up, towards the observers. */
struct eye {
    double x, y, z;
};

struct display {
    double unit;                    /* that lengths are rounded to */
    double width, height, distance; /* of the screen; of the observer line from it */
    double from, to;                /* the line's ends */
    unsigned count;                 /* of pictures */
    bool projects;                  /* they are modules' */
    double spacing, behind;         /* of modules */
};

/* For the views of a scene with an observer line, or for modules unless NULL. */
void display_init(struct display *display, const struct tia_scene *scene, unsigned views,
                  const struct modules *modules);

/* Where the ray from the eye through a point of the screen, a part of its width from the left, crosses the observer
 * line's plane: 0 at the line's left end, 1 at its right end, also beyond them. */
double display_part(const struct display *display, const struct eye *eye, double point);

/* The picture that an eye sees of column `column` of `columns`; -1: none, it is black. Of views that is the one whose
 * eye is nearest to where the ray from the eye through the column's middle crosses the observer line's plane, of
 * modules the one nearest to where it comes from behind the screen; halfway between two the right one. Where that
 * module's light misses the line, but the eye's ray does not, it is the next one, whose light does not either. The
 * eye's height makes no difference: there is horizontal parallax only. */
int display_picture(const struct display *display, const struct eye *eye, unsigned column, unsigned columns);

#endif
