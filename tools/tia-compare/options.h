/* options.h - the command line of tia-compare. */
#ifndef TIA_COMPARE_OPTIONS_H
#define TIA_COMPARE_OPTIONS_H

#include <stdbool.h>
#include <stdint.h>

#include "common/command_line.h"

struct options {
    const char *keys;             /* NULL: draw the built-in scene as it is, and after each of its keys */
    bool thesis;                  /* the built-in scene's frames */
    unsigned random, rays_random; /* number of random scenes, for the span and the ray renderer */
    uint64_t seed;
    char **scenes; /* files, scene_count of them */
    int scene_count;
    uint16_t width, height; /* 0: 1920x1080 for the built-in scene, 640x480 for files, random scenes choose their own */
    unsigned threads;
    bool json, summary;
    const char *heatmap;
    double require_identical;      /* percent; negative: not given */
    int64_t max_flips, max_levels; /* negative: not given */
    bool shadows;                  /* compare techniques for shadows instead */
    unsigned light, best_of;       /* with shadows; light 0: all */
    const char *technique;         /* only this one; NULL: all */
};

/* COMMAND_RUN; or the status to exit with, 0 after --help and --version, else after an error message. */
int options_parse(struct options *options, int argc, char **argv);

#endif
