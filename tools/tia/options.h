/* options.h - what the user asked for on the command line. */
#ifndef TOOLS_TIA_OPTIONS_H
#define TOOLS_TIA_OPTIONS_H

#include <tia/tia.h>

#include "image/image.h"

enum action { ACTION_SHOW, ACTION_DRAW, ACTION_HELP, ACTION_VERSION, ACTION_LIST, ACTION_MODES };

struct options {
    enum action action;
    const struct tia_scene *scene;
    const struct tia_core *core;
    const char *display, *display_device; /* "auto" and NULL by default */
    const char *input, *input_device;
    const char *connector, *mode; /* NULL: not given */
    const char *output;           /* NULL: a display */
    enum image_format format;
    uint16_t width, height; /* 0: not given */
    uint16_t *keys;         /* pressed first; options_free frees them */
    size_t key_count;
    uint32_t frames; /* 0: no limit */
    uint32_t threads;
    uint32_t rotate; /* degrees, clockwise */
    bool dither, checksum, stats;
};

/* EXIT_FINE; or EXIT_USAGE, EXIT_DISPLAY, EXIT_RUNNING after one line that says what is wrong. */
int options_parse(struct options *options, int argc, char **argv);
void options_free(struct options *options);

extern const char options_help[];

#endif
