/* move.h - control by keys and the mouse, in every scene but the built-in one: see struct tia_control. */
#ifndef TOOLS_TIA_MOVE_H
#define TOOLS_TIA_MOVE_H

#include <tia/viewer.h>

#include "camera_line.h"
#include "common/steer.h"
#include "device.h"
#include "letterbox.h"
#include "options.h"

/* The key of an event that reports a changed file. */
#define MOVE_CHANGED 0x200

/* Keys that scroll the help; see moves_scroll_key. */
enum { MOVE_LINE_UP = 0x201, MOVE_LINE_DOWN, MOVE_PAGE_UP, MOVE_PAGE_DOWN };

enum move_to { MOVE_NOWHERE, MOVE_NEXT_SCENE, MOVE_PREVIOUS_SCENE, MOVE_NEXT_VIEW, MOVE_READ_AGAIN };

struct moves {
    /* Set by the caller; all else zero. */
    const struct options *options;
    const struct letterbox *letterbox;     /* a letterbox with `keeps` set */
    const struct tia_viewer_state *viewer; /* the changes that keys have made */
    struct port_text *text;                /* the text on a display that has it */

    /* For the caller to read. */
    enum move_to to;        /* the user's choice, to be read after the loop */
    bool help;              /* help is shown */
    char message[PORT_WHY]; /* message of the last key, if any */
    uint64_t until_us;      /* time when the message ends */
    char line[CAMERA_LINE]; /* the camera of the last key `e`, to be printed at the end; empty: there was none */
    char broken[PORT_WHY];  /* why the changed scene cannot be shown, until it can; empty: it is shown */

    /* Private. */
    bool saves;     /* a key has requested that the picture be saved when it is complete */
    unsigned saved; /* last number used by save_numbered */
    struct steer steer;
};

/* Returns the effect of an event, without applying it: see struct tia_control. */
enum tia_effect moves_weigh(const struct moves *moves, const struct tia_event *event);
/* Applies an event; may move the camera. Returns its effect. */
enum tia_effect moves_act(struct moves *moves, const struct tia_event *event, struct tia_camera *camera);

/* Saves the picture if a key has requested that and the frame is complete, not coarse; call it after each frame. */
void moves_shown(struct moves *moves, const struct tia_frame *frame);

/* Saves a picture that was to be saved when complete, as far as it is drawn; call it after the loop. False: none was to
 * be saved; else `text` receives the result. */
bool moves_finish(struct moves *moves, char text[PORT_WHY]);

/* Shows a line for a few seconds. */
void moves_say(struct moves *moves, const char *text);

/* Returns the help to show, or NULL. Its lines are "KEYS\tMEANING". */
const char *moves_help(const struct moves *moves);

/* Returns the key by which `key` scrolls the help while that has more lines than the display shows; else `key`. */
uint16_t moves_scroll_key(const struct moves *moves, uint16_t key);

#endif
