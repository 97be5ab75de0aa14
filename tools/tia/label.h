/* label.h - text in the upper left corner of a picture. */
#ifndef TOOLS_TIA_LABEL_H
#define TOOLS_TIA_LABEL_H

#include <tia/text.h>

/* Returns the text for a picture of `height` rows: white on black, larger in large pictures. */
struct tia_text label_text(const char *text, unsigned height);

#endif
