#include "label.h"

struct tia_text label_text(const char *text, unsigned height)
{
    unsigned scale = height / 320 > 1 ? height / 320 : 1; /* room for 39 lines of text, unless the picture is small */

    return (struct tia_text){text, 0, 0, (uint16_t)scale, 0xffff, 0};
}
