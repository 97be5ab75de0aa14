/* options.h - the command line of tia-compare. */
#ifndef TIA_COMPARE_OPTIONS_H
#define TIA_COMPARE_OPTIONS_H

#include <stdbool.h>
#include <stdint.h>

struct options {
    const char *keys;             /* NULL: the built-in scene as it is and after each of its keys */
    bool thesis;                  /* the built-in scene's frames */
    unsigned random, rays_random; /* how many random scenes, of balls and for general rays */
    uint64_t seed;
    char **scenes; /* files, scene_count of them */
    int scene_count;
    unsigned width, height; /* 0: 1920x1080 for the built-in scene, 640x480 for files, random ones their own */
    unsigned threads;
    bool json, summary;
    const char *heatmap;
    double require_identical;      /* percent; negative: not asked */
    int64_t max_flips, max_levels; /* negative: not asked */
};

/* 0: go on; 1: done (--help); -1: a mistake, named on standard error. */
int options_parse(struct options *options, int argc, char **argv);

#endif
