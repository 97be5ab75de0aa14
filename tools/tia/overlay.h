/* overlay.h - the viewer's messages: pixels of the picture, or text on a display that has it. */
#ifndef TOOLS_TIA_OVERLAY_H
#define TOOLS_TIA_OVERLAY_H

#include <stddef.h>
#include <tia/viewer.h>

#include "move.h"
#include "options.h"

struct overlay {
    const struct options *options;
    bool labelled;       /* a key has changed the shadow technique */
    uint64_t shown_us;   /* time when a frame was last completed */
    uint64_t between_us; /* time between the last two completed frames; 0: unknown */
    uint64_t draw_us;    /* time to draw the last frame that was not only shown again */
    uint64_t key_us;     /* latency of the last frame that shows the effect of a key; 0: unknown */
    unsigned width, height, threads;
    const struct moves *moves;             /* NULL, or the source of the keys' messages */
    const struct tia_viewer_state *viewer; /* the changes that keys have made */
    bool hints; /* name keys: in a status always, else on the picture, of the built-in scene until it has a light or,
                   with --keys, never; of others until one is complete */
    struct port_text text;                           /* the text for a display that has it */
    char status[256], notes[1024], window_title[96]; /* strings of `text` */
};

/* Writes the text for a picture that has been drawn but not shown; empty when there are no messages. */
void overlay_text(struct overlay *overlay, const struct tia_frame *frame, char *text, size_t size);

/* Fills in overlay->text for such a picture, for a display that has text; text.first stays. */
void overlay_words(struct overlay *overlay, const struct tia_frame *frame);

/* Updates the overlay when a frame is complete and shown. */
void overlay_shown(struct overlay *overlay, const struct tia_frame *frame);

#endif
