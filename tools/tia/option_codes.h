/* option_codes.h - what getopt_long returns for options without a letter. */
#ifndef TOOLS_TIA_OPTION_CODES_H
#define TOOLS_TIA_OPTION_CODES_H

enum {
    OPT_FORMAT = 256, /* greater than any character */
    OPT_SCENE_FORMAT,
    OPT_SAMPLES,
    OPT_DEPTH,
    OPT_SHADOWS,
    OPT_INTEGRATOR,
    OPT_SPP,
    OPT_SAMPLES_RANGE,
    OPT_RESUME,
    OPT_DENOISE,
    OPT_GUIDE,
    OPT_TIME_LIMIT,
    OPT_ERROR,
    OPT_TONE,
    OPT_EXPOSURE,
    OPT_COLOUR,
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
    OPT_GAZE,
    OPT_VIEW_ANGLE,
    OPT_W0,
    OPT_M,
    OPT_SMOOTH,
    OPT_LIST,
    OPT_STRICT
};

#endif
