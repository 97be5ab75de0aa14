/* parse_option.h - parses the value of one option. */
#ifndef TOOLS_TIA_PARSE_OPTION_H
#define TOOLS_TIA_PARSE_OPTION_H

#include "options.h"

/* Options without a letter. */
enum {
    OPT_FORMAT = 256, /* greater than any character */
    OPT_SCENE_FORMAT,
    OPT_SAMPLES,
    OPT_DEPTH,
    OPT_SHADOWS,
    OPT_MAP_SIZE,
    OPT_BIAS,
    OPT_FILTER,
    OPT_TESSELLATED,
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
    OPT_STATS_OVERLAY,
    OPT_PROGRESS,
    OPT_VIEW,
    OPT_DRAW_RAYS,
    OPT_LIST,
    OPT_STRICT
};

/* EXIT_FINE, or EXIT_USAGE after an error message. May change the text of `value`. */
int parse_option(struct options *options, int option, char *value);

#endif
