/* benchmark.h - the benchmark's frames: a fixed set, compiled in, each with the CRC-32 that it has on every processor.
 */
#ifndef TOOLS_BENCHMARK_BENCHMARK_H
#define TOOLS_BENCHMARK_BENCHMARK_H

#include <stdint.h>

/* The version of the set. With the same set and the same version of docs/definition.md, frames and CRCs are the same.
 */
#define BENCHMARK_SET 1

enum { BENCHMARK_FRAMES = 4 };

struct benchmark_frame {
    const char *name;
    uint16_t width, height; /* pixels */
    const char *scene;      /* text of the scene; NULL: the built-in scene with key a pressed */
    uint32_t crc;           /* CRC-32 of all pixels, RGB565, as --checksum prints it */
};

extern const struct benchmark_frame benchmark_frames[BENCHMARK_FRAMES];

/* The texts of scenes, see scenes.c. */
extern const char benchmark_rays[], benchmark_paths[], benchmark_shadows[];

#endif
