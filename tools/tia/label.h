/* label.h - text in the upper left corner of a picture: so it is there on every display. */
#ifndef TOOLS_TIA_LABEL_H
#define TOOLS_TIA_LABEL_H

#include <tia/text.h>

/* The text in a picture of that many rows: white on black, larger in large pictures. */
struct tia_text label_text(const char *text, unsigned height);

#endif
