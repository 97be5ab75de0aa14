/* display.h - the directions of a light-field display: the picture that each column of its screen shows to an eye. */
#ifndef TOOLS_TIA_OBSERVE_DISPLAY_H
#define TOOLS_TIA_OBSERVE_DISPLAY_H

#include <stdbool.h>
#include <tia/scene.h>

#include "common/modules.h"

/* A position in front of the screen, from its middle, in the scene's unit: to the right, up, towards the observers. */
struct eye {
    double x, y, z;
};

struct display {
    double unit;                    /* unit of rounded lengths */
    double width, height, distance; /* size of the screen; distance of the observer line from it */
    double from, to;                /* the line's ends */
    unsigned count;                 /* number of pictures */
    bool projects;                  /* the pictures are modules' */
    double spacing, behind;         /* spacing of modules; their distance behind the screen */
};

/* Prepares the views of a scene with an observer line, or, unless NULL, modules. */
void display_init(struct display *display, const struct tia_scene *scene, unsigned views,
                  const struct modules *modules);

/* Returns where the ray from the eye through a point of the screen, a part of its width from the left, crosses the
 * observer line's plane: 0 at the line's left end, 1 at its right end, also beyond them. */
double display_part(const struct display *display, const struct eye *eye, double point);

/* Returns the picture that column `column` of `columns` shows to an eye; -1: none, it is black. For views, that is the
 * one whose eye is nearest to the point where the ray from the eye through the column's middle crosses the observer
 * line's plane; for modules, the one nearest to its origin behind the screen; halfway between two, the right one. Where
 * that module's light misses the line, but the eye's ray does not, it is the next one, whose light does not either. The
 * eye's height makes no difference: there is horizontal parallax only. */
int display_picture(const struct display *display, const struct eye *eye, unsigned column, unsigned columns);

#endif
