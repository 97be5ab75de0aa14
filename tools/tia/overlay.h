/* overlay.h - what the viewer tells on the picture. */
#ifndef TOOLS_TIA_OVERLAY_H
#define TOOLS_TIA_OVERLAY_H

#include <stddef.h>
#include <tia/viewer.h>

#include "move.h"
#include "options.h"

struct overlay {
    const struct options *options;
    bool labelled;       /* a key has changed the technique for shadows */
    uint64_t shown_us;   /* when a frame was last completed */
    uint64_t between_us; /* from the one before to that; 0: not known */
    uint64_t key_us;     /* the latency of the last frame that a key has asked for */
    unsigned width, height, threads;
    const struct moves *moves;             /* NULL, or what keys have to tell */
    const struct tia_viewer_state *viewer; /* what they have changed */
    bool hints;                            /* says which keys put the light, while there is none */
};

/* The text for a picture that has been drawn but not shown; empty when there is nothing to tell. */
void overlay_text(struct overlay *overlay, const struct tia_frame *frame, char *text, size_t size);

/* A frame is complete and shown. */
void overlay_shown(struct overlay *overlay, const struct tia_frame *frame);

#endif
