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
    unsigned ties, hard;          /* number of random scenes of balls with equal sides, and of those that are hard */
    uint64_t seed;
    char **scenes; /* files, scene_count of them */
    int scene_count;
    uint16_t width, height; /* 0: the default, 1920x1080 for the built-in scene, 640x480 for files; random scenes choose
                               their own */
    unsigned threads;
    bool json, summary, dither;
    const char *heatmap;
    const char *arithmetic;        /* the reference's name */
    double require_identical;      /* least percentage of identical pixels that is accepted; negative: not given */
    int64_t max_flips, max_levels; /* largest accepted values; negative: not given */
    bool exact;                    /* compare with the exact picture instead of f64 */
    unsigned every;                /* with `exact`: compare every Nth pixel */
    bool shadows;                  /* compare techniques for shadows instead of arithmetics */
    unsigned light, best_of;       /* with `shadows`: number of the light to compare, 0 for all lights */
    const char *technique;         /* the only technique to compare; NULL: all */
};

/* Parses the command line. Returns COMMAND_RUN; or the status to exit with, 0 after --help and --version, else after an
 * error message. */
int options_parse(struct options *options, int argc, char **argv);

#endif
