/* convert.h - a command that takes a scene file to another language: TOOL SCENE -o FILE. */
#ifndef TOOLS_CONVERT_H
#define TOOLS_CONVERT_H

#include <tia/scene.h>

struct request {
    const char *scene, *output; /* paths; "-": standard input, standard output */
    int format;                 /* of the scene, SCENE_UNKNOWN: as its name says */
    const char *symbol;         /* --name */
    char source[64];            /* the scene's name as it may stand in a comment */
};

struct converter {
    const char *tool, *usage;
    const char *symbol; /* without --name; NULL: there is no --name */
    /* Writes request->output. TIA_OK, or a failure and *why, PORT_WHY bytes. */
    int (*write)(const struct request *request, const struct tia_scene *scene, char *why);
};

/* The whole command; returns its exit status: 0 fine, 1 failed, 2 wrong usage or no scene. */
int convert(const struct converter *converter, int argc, char **argv);

#endif
