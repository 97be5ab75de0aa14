/* simd_lights.h - a scene for each kind of light that SIMD kernels support. */
#ifndef TESTS_SIMD_LIGHTS_H
#define TESTS_SIMD_LIGHTS_H

#include <stdio.h>

#include "reading.h"
#include "with_hierarchy.h"

static const char *const light_lines[] = {"light point at 1 3 2 radius 0.3",
                                          "light directional direction -1 -3 -2",
                                          "light ambient emission 0.6",
                                          "light spot at 1 3 2 direction -1 -3 -2 inner 10 outer 20",
                                          "light rectangle at 1 3 2 sides 0.5 0 0.1 0 0 0.4 samples 4",
                                          "light disc at 1 3 2 direction -1 -3 -2 radius 0.5 samples 4",
                                          "light sphere at 1 3 2 radius 0.4 samples 4"};

enum { LIGHT_LINES = sizeof light_lines / sizeof *light_lines };

/* Calls `then` with the scene whose light is light_lines[i], and with i. */
static inline void with_light(unsigned i, void (*then)(const struct tia_scene *, unsigned))
{
    static struct reading reading;
    char text[512];

    (void)snprintf(text, sizeof text,
                   "camera eye 0 1 6 look 0 1 0 fov 60\nmaterial plain colour 0.7 0.6 0.5 mirror 0.2\n%s\n"
                   "plane point 0 -0.5 0 normal 0 1 0 material plain\n"
                   "sphere centre 0 0 0 radius 0.5 material plain\n",
                   light_lines[i]);
    read_string(&reading, TIA_FORMAT_TIA, text);
    CHECK_MSG(reading.status == TIA_OK, "%s", reading.reader.error.text);
    with_hierarchy(&reading.scene, then, i);
    read_end(&reading);
}

#endif
