/* eye_views.h - draws a light-field display's screen, from edge to edge, as seen by one or two eyes. */
#ifndef TOOLS_TIA_OBSERVE_EYE_VIEWS_H
#define TOOLS_TIA_OBSERVE_EYE_VIEWS_H

#include "common/image/series.h"
#include "field_display.h"
#include "field_pictures.h"
#include "panel.h"

struct observation {
    struct display display;
    struct pictures pictures;
    bool lenses; /* the only picture is that of a panel with lenses */
    struct panel panel;
    struct eye eye, to; /* position of the eye, or of the middle between two; its position in the film's last frame */
    double apart;       /* distance between two eyes; 0: one eye */
    bool anaglyph;      /* both eyes' views are in one picture, red for the left eye; else side by side */
    unsigned width, height; /* size of one eye's picture */
};

/* Draws all frames of the series. Returns a negative status on failure, with the reason in series->why. */
int observe(const struct observation *observation, struct series *series);

#endif
