/* take.h - the values of the command's options, one option at a time. */
#ifndef TOOLS_TIA_TAKE_H
#define TOOLS_TIA_TAKE_H

#include "options.h"

/* Those without a letter. */
enum {
    OPT_FORMAT = 256, /* above every character */
    OPT_SCENE_FORMAT,
    OPT_SAMPLES,
    OPT_TIME,
    OPT_FPS,
    OPT_FRAME_RANGE,
    OPT_TILE_ROWS,
    OPT_ARITHMETIC,
    OPT_DITHER,
    OPT_ROTATE,
    OPT_CONNECTOR,
    OPT_MODE,
    OPT_CHECKSUM,
    OPT_STATS,
    OPT_LIST
};

/* EXIT_FINE, or EXIT_USAGE after one line that says what is wrong. `value` may be cut into pieces. */
int take(struct options *options, int option, char *value);

#endif
