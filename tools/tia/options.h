/* options.h - the command line. */
#ifndef TOOLS_TIA_OPTIONS_H
#define TOOLS_TIA_OPTIONS_H

#include <tia/tia.h>

#include "common/command_line.h"
#include "common/image/image.h"
#include "common/scene/scene.h"
#include "common/views/views.h"
#include "lightfield_options.h"

enum action { ACTION_SHOW, ACTION_DRAW, ACTION_LIST, ACTION_MODES };

struct options {
    enum action action;
    const char *scene_path; /* NULL: the built-in scene */
    int scene_format;       /* enum tia_format, or SCENE_UNKNOWN */
    char **scene_paths;     /* all that are named; scene_path is one of them */
    uint32_t scene_count, scene_index;
    int format_of_scenes;         /* that is given for all of them, or SCENE_UNKNOWN */
    struct scene_file file;       /* if there is a path */
    struct tia_scene scene;       /* the scene to draw, with --samples and --depth applied */
    struct tia_scene plain_scene; /* and as it is without false colours */
    uint32_t samples;             /* 0: the scene's own; also the depth */
    uint32_t depth;
    uint32_t shadows;          /* 0: the scene's; n: technique n - 1 */
    struct tia_shadow_map map; /* what is not 0 overrides the scene's */
    uint32_t integrator;       /* 0: the scene's; n: integrator n - 1 */
    const char *distance;      /* of it; NULL: not given */
    uint32_t spp, tone;        /* 0: the scene's */
    bool samples_range;
    uint32_t first_sample, last_sample; /* for samples_range */
    const char *resume;                 /* NULL: not given */
    bool denoise;
    uint32_t guide;            /* enum tia_shown_guide */
    tia_q16 time_limit, error; /* 0: not given */
    const char *exposure;      /* NULL: not given */
    unsigned depth_bits;       /* of a picture, see struct image_film */
    bool colour_given;
    const char *tessellated;                  /* NULL: not given */
    const struct tia_core *core, *plain_core; /* what draws; and what draws without false colours */
    struct views views;                       /* without its core */
    struct light_options light;
    struct tia_gaze gaze; /* its angle 0: the default */
    bool gazes;
    bool w0_given, m_given;
    const struct tia_simd *simd;          /* vector units; NULL: plain C */
    const char *display, *display_device; /* "auto" and NULL by default */
    const char *input, *input_device;
    const char *connector, *mode; /* NULL: not given */
    const char *output;           /* NULL: a display */
    enum image_format format;
    uint16_t width, height; /* 0: not given */
    const char *key_text;   /* NULL: not given */
    uint16_t *keys;         /* pressed before the first frame */
    size_t key_count;
    uint32_t frames;  /* 0: no limit */
    tia_q16 time;     /* of the first frame, seconds */
    uint32_t rate[2]; /* frames per second: numerator, denominator */
    bool rate_given, frame_range, tile_rows;
    uint32_t first_frame, last_frame, first_row, last_row; /* for frame_range and tile_rows */
    uint32_t threads;
    uint32_t rotate; /* degrees, clockwise */
    bool dither, checksum, stats, stats_overlay, progress, strict;
};

extern const struct command tia_command; /* of struct options */

#endif
