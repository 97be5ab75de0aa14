/* corpus.h - the scenes for measuring accuracy: the built-in one, and random ones, the same on every machine. */
#ifndef TOOLS_COMMON_CORPUS_CORPUS_H
#define TOOLS_COMMON_CORPUS_CORPUS_H

#include <tia/port.h>

#define CORPUS_BALLS 8
#define CORPUS_LIGHTS 3

/* A scene and the arrays that it points to; do not copy it. */
struct corpus_scene {
    struct tia_scene scene;
    unsigned width, height;
    struct tia_material materials[CORPUS_BALLS + 1];
    struct tia_sphere spheres[CORPUS_BALLS + 1];
    struct tia_light lights[CORPUS_LIGHTS];
};

/* Makes random scene number `index` of the series `seed`: a ground of radius 10000, 1 to 8 balls of radius 0.25 to 6
 * that may touch and overlap, 1 to 3 lights, an eye 0.5 to 60 above the ground, a field of view of 10 to 90 degrees, an
 * image of 320x240 to 1920x1080. In every fourth scene some balls are transparent to light, in every fifth some glow.
 * tia_scene_check accepts all of them. */
void corpus_random(struct corpus_scene *out, uint64_t seed, unsigned index);

/* Makes tia_thesis_scene as it is after the keys `keys`, for a width x height image. Returns TIA_ERR_ARGUMENT if a key
 * quits. */
int corpus_thesis(struct corpus_scene *out, const char *keys, unsigned width, unsigned height);

#endif
