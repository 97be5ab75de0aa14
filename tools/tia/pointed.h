/* pointed.h - an input (tia/port.h) around another one: converts its pointer's position on the screen to one in the
 * picture that a letterbox places there. */
#ifndef TOOLS_TIA_POINTED_H
#define TOOLS_TIA_POINTED_H

#include "file_watch.h"
#include "letterbox.h"

struct pointed {
    const struct tia_input *input;
    void *input_ctx;
    const struct letterbox *letterbox;
    struct file_watch *watch; /* NULL, or what reports changed files, as a key MOVE_CHANGED */
};

extern const struct tia_input pointed_input; /* the context is a struct pointed, whose input is open */

#endif
