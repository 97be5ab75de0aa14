/* pointed.h - an input (tia/port.h) around another one: converts its pointer's position on the screen to one in the
 * picture that a letterbox places there, and keys to those that scroll the help. */
#ifndef TOOLS_TIA_POINTED_H
#define TOOLS_TIA_POINTED_H

#include "file_watch.h"
#include "letterbox.h"
#include "move.h"

struct pointed {
    const struct tia_input *input;
    void *input_ctx;
    const struct letterbox *letterbox;
    const struct moves *moves; /* what scrolls the help */
    struct file_watch *watch;  /* NULL, or what reports changed files, as a key MOVE_CHANGED */
};

extern const struct tia_input pointed_input; /* the context is a struct pointed, whose input is open */

#endif
