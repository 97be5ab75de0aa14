/* label.h - a line of text for the corner of a picture, in letters of 3x5 squares: so it is there on every display. */
#ifndef TOOLS_TIA_LABEL_H
#define TOOLS_TIA_LABEL_H

#include <tia/render.h>

/* Where the label goes in a picture of this size, at its upper left corner; what does not fit is cut off. */
struct tia_tile label_area(const char *text, unsigned width, unsigned height);

/* Whether pixel (x, y) of the area is part of a letter. There are letters without cases, digits, the dot, the hyphen
 * and the space; others are spaces. */
bool label_is_ink(const char *text, unsigned height, unsigned x, unsigned y);

#endif
