/* move.h - what keys and the mouse do in every scene but the built-in one: see struct tia_control. */
#ifndef TOOLS_TIA_MOVE_H
#define TOOLS_TIA_MOVE_H

#include <tia/viewer.h>

#include "common/steer.h"
#include "device.h"
#include "letterbox.h"
#include "options.h"

enum move_to { MOVE_NOWHERE, MOVE_NEXT_SCENE, MOVE_PREVIOUS_SCENE, MOVE_NEXT_VIEW };

struct moves {
    /* Set by the caller; all else zero. */
    const struct options *options;
    const struct letterbox *letterbox;     /* that keeps its picture */
    const struct tia_viewer_state *viewer; /* what keys have changed */

    /* For the caller to read. */
    enum move_to to;        /* what is wanted after the loop */
    bool help;              /* is shown */
    char message[PORT_WHY]; /* what the last key has done, if it is worth telling */
    uint64_t until_us;      /* and how long */

    /* Private. */
    bool saves;     /* the picture is to be saved when it is complete */
    unsigned saved; /* see save_numbered */
    struct steer steer;
};

extern const struct tia_control moves_control; /* the context is a struct moves */

/* A frame is shown; coarse ones are not complete. */
void moves_shown(struct moves *moves, const struct tia_frame *frame);

/* After the loop: saves the picture that was to be saved when it is complete, as far as it is drawn. Whether there was
 * one; `text` says what has become of it. */
bool moves_finish(struct moves *moves, char text[PORT_WHY]);

/* Tells a line for a few seconds. */
void moves_say(struct moves *moves, const char *text);

/* What to show of the keys, or NULL; lines. */
const char *moves_help(const struct moves *moves);

#endif
