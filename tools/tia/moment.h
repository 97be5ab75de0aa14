/* moment.h - the scene at the time of a frame, ready to be drawn. */
#ifndef TOOLS_TIA_MOMENT_H
#define TOOLS_TIA_MOMENT_H

#include "lights.h"
#include "options.h"

struct moment {
    const struct options *options;
    const struct tia_scene *scene; /* at that time */
    struct tia_view *view;
    char *why; /* [PORT_WHY] */

    /* Its own. */
    struct tia_scene moved;
    void *moving, *boxes, *view_memory;
    size_t moving_bytes, boxes_bytes, view_bytes;
    struct lights lights;
};

/* Presses the keys, at the time of frame 0. A negative status, and *why for TIA_ERR_RANGE. */
int moment_begin(struct moment *moment, const struct options *options, char *why);

/* The view becomes that of frame `frame`. */
int moment_at(struct moment *moment, uint32_t frame);

/* Safe after a failure. */
void moment_end(struct moment *moment);

#endif
