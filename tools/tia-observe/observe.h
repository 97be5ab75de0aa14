/* observe.h - what eyes see of a light field: the screen from edge to edge, as pictures. */
#ifndef TOOLS_TIA_OBSERVE_OBSERVE_H
#define TOOLS_TIA_OBSERVE_OBSERVE_H

#include "common/image/series.h"
#include "display.h"
#include "panel.h"
#include "pictures.h"

struct observation {
    struct display display;
    struct pictures pictures;
    bool lenses; /* the only picture is the panel's */
    struct panel panel;
    struct eye eye, to;     /* where the eye is, or the middle between two; where it is in the film's last frame */
    double apart;           /* two eyes; 0: one */
    bool anaglyph;          /* both in one picture: red is what the left one sees; else side by side */
    unsigned width, height; /* of what one eye sees */
};

/* Draws all frames of the series. A negative status on failure, with the reason in series->why. */
int observe(const struct observation *observation, struct series *series);

#endif
