/* panel.h - the subpixels of a lenticular panel that send their light to an eye, by the formula of tia/lightfield.h. */
#ifndef TOOLS_TIA_OBSERVE_PANEL_H
#define TOOLS_TIA_OBSERVE_PANEL_H

#include <stdint.h>
#include <tia/lightfield.h>

struct panel {
    double pitch, rise, centre; /* numbers as in struct tia_lenticular */
    enum tia_subpixels subpixels;
    bool flipped, inverted;
    unsigned width, height; /* size of the panel's picture */
};

void panel_init(struct panel *panel, const struct tia_lenticular *lens, unsigned width, unsigned height);

/* Returns the column of the panel's picture that an eye sees at a point of the screen, in channel 0..2: red, green or
 * blue. Rows are counted from above. Candidates are the subpixels of that colour in the row whose middles are within
 * half a lens of the point; without any, the point is black, and the result is -1. Of the candidates, it is the one
 * whose phase is nearest to the eye's; of equally near ones, the left one of the shown picture. Phases are compared
 * modulo 1: the views repeat beyond the line's ends. `point` is a fraction of the screen's width, `phase` a fraction of
 * the observer line, both from the left. */
int panel_column(const struct panel *panel, unsigned row, unsigned channel, double point, double phase);

#endif
