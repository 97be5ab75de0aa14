/* convert.h - a command that converts a scene file: TOOL SCENE -o FILE. */
#ifndef TOOLS_CONVERT_H
#define TOOLS_CONVERT_H

#include <tia/render.h>

#include "choices.h"
#include "command_line.h"

#define CONVERT_TILES 16

struct convert_tiles {
    uint16_t size[CONVERT_TILES][2]; /* widths and heights */
    unsigned count;
};

#define CONVERT_TELLTALES 16

/* Rectangles of a picture, for tia-compile --crc. */
struct convert_telltales {
    uint16_t width, height; /* 0: no --crc */
    unsigned count;
    struct {
        const char *name;
        struct tia_tile area;
    } of[CONVERT_TELLTALES];
};

struct request {
    const char *scene, *output; /* paths; "-": standard input, standard output */
    int format;                 /* format of the scene; SCENE_UNKNOWN: by the file's name */
    bool strict;
    const char *symbol; /* value of --name */
    char source[64];    /* the scene's name, without characters that would end a comment */

    /* For a command with `write_memory`. */
    const char *memory;         /* --memory: NULL, or a path; then `output` may be NULL */
    uint32_t lights;            /* --lights: 0 when it is not given */
    struct convert_tiles tiles; /* --size */

    struct convert_telltales telltales; /* --crc, --rectangle */
};

#define CONVERT_TO(member) OPTION_TO(struct request, member)
/* The last rows of every converter's table, and the end of its --help. */
#define CONVERT_END                                                                                                    \
    {"scene-format",    0, OPTION_CHOICE, SCENE_FORMATS, "the format of SCENE, if its name has no such extension",     \
     CONVERT_TO(format)},                                                                                              \
        {"strict", 0, OPTION_FLAG, NULL, "treat warnings about the scene as errors", CONVERT_TO(strict)}, OPTION_END
#define CONVERT_NOTES "\nExit status: 0 success, 1 failure, 2 usage error or invalid scene.\n"

struct converter {
    const struct command *command; /* its options fill a struct request */
    const char *symbol;            /* default of --name */
    /* writes request->output; returns TIA_OK, or a failure with the reason in `why`, PORT_WHY bytes */
    int (*write)(const struct request *request, const struct tia_scene *scene, char *why);
    /* writes request->memory; returns as `write`; NULL: the command has no --memory */
    int (*write_memory)(const struct request *request, const struct tia_scene *scene, char *why);
    /* returns the first option that does not fit the others, with the reason in `why`, or NULL; NULL: all fit */
    const char *(*check)(const struct request *request, const char **why);
};

/* Runs the whole command; returns its exit status: 0 success, 1 failure, 2 usage error or invalid scene. */
int convert(const struct converter *converter, int argc, char **argv);

#endif
