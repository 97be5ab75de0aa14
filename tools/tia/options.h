/* options.h - the command line. */
#ifndef TOOLS_TIA_OPTIONS_H
#define TOOLS_TIA_OPTIONS_H

#include <tia/tia.h>

#include "common/command_line.h"
#include "common/image/image.h"
#include "common/row_tap.h"
#include "common/scene/scene_load.h"
#include "common/views/views.h"
#include "device.h"
#include "eye_options.h"
#include "file_watch.h"
#include "lightfield_options.h"

enum action { ACTION_SHOW, ACTION_DRAW, ACTION_LIST, ACTION_MODES, ACTION_WRITE };

/* Names of a model's materials, by index; NULL for those without. */
struct write_names {
    char **names;
    uint32_t count;
};

/* A display or an input: "auto" by default. */
struct port_option {
    const char *name, *device; /* device: NULL if not given */
};

struct integrator_option {
    uint32_t number;      /* 0: the scene's; n: integrator n - 1 */
    const char *distance; /* distance of TIA_OCCLUSION; NULL: not given */
};

struct options {
    enum action action;
    const char *scene_path; /* path of the scene; NULL: the built-in scene */
    int scene_format;       /* enum tia_format, or SCENE_UNKNOWN */
    char **scene_paths;     /* all scenes of the command line; scene_path is one of them */
    uint32_t scene_count, scene_index;
    int format_of_scenes;         /* format given for all scenes, or SCENE_UNKNOWN */
    struct scene_file file;       /* the scene's file, if there is a path */
    struct tia_scene scene;       /* the scene to draw, with the options applied */
    struct tia_scene plain_scene; /* the same without false colours */
    uint32_t samples;             /* rays per pixel; 0: the scene's */
    uint32_t depth;               /* depth of rays; 0: the scene's */
    uint32_t shadows;             /* 0: the scene's; n: technique n - 1 */
    struct tia_shadow_map map;    /* members that are not 0 override the scene's */
    struct integrator_option integrator;
    uint32_t spp, tone; /* 0: the scene's */
    bool samples_range;
    uint32_t first_sample, last_sample; /* bounds of samples_range */
    const char *resume;                 /* NULL: not given */
    bool denoise;
    uint32_t guide;            /* enum tia_shown_guide */
    tia_q16 time_limit, error; /* 0: not given */
    const char *exposure;      /* NULL: not given */
    uint32_t colour;           /* 0: RGB565; n: 8 n bits a channel */
    unsigned depth_bits;       /* bits per channel of a picture, see struct image_film */
    bool colour_given;
    const char *tessellated;                  /* NULL: not given */
    const struct tia_core *core, *plain_core; /* the core that draws; the core that draws without false colours */
    struct views views;                       /* false colours and drawn rays */
    struct eye_options eye;
    struct light_options light;
    struct tia_gaze gaze; /* view_angle 0: the default */
    bool gazes;
    bool w0_given, m_given;
    const struct tia_simd *simd; /* vector units; NULL: plain C */
    struct port_option display, input;
    const char *connector, *mode;               /* NULL: not given */
    const char *output;                         /* path of the file; NULL: a display */
    const struct row_tap *tap;                  /* NULL, or receives the rows of the file */
    const char *record;                         /* NULL, or the record's file */
    bool (*opens)(void *ctx, const char *path); /* NULL, or asked about each file before it is read */
    void *opens_ctx;
    char *given; /* the options as given, "name=value" or "name", each with its NUL, see arguments_parse; NULL: none */
    size_t given_bytes;
    const char *write;        /* --write: path of the scene; NULL: none */
    struct write_names names; /* for --write */
    enum image_format format;
    uint16_t width, height; /* 0: not given */
    uint32_t thumbnail;     /* size of a thumbnail; 0: not given */
    const char *key_text;   /* NULL: not given */
    uint16_t *keys;         /* keys pressed before the first frame */
    size_t key_count;
    uint32_t frames;  /* number of frames; 0: no limit */
    bool in_line;     /* print the picture into a terminal's scrollback */
    tia_q16 time;     /* time of the first frame, seconds */
    uint32_t rate[2]; /* frames per second: numerator, denominator */
    bool rate_given, frame_range, tile_rows;
    uint32_t first_frame, last_frame, first_row, last_row; /* bounds of frame_range and tile_rows */
    uint32_t threads;
    uint32_t rotate;          /* degrees, clockwise */
    bool watches;             /* --watch */
    struct file_watch *watch; /* NULL, or gets the files that are read */
    char broken[PORT_WHY];    /* with --watch: why the scene could not be read at first; empty: it was */
    bool benchmark;           /* --benchmark */
    bool dither, checksum, stats, stats_overlay, progress, notify, strict;
    bool checks; /* only tell the mistakes of the scenes */
};

extern const struct command tia_command; /* its options fill a struct options */

#endif
