/* frames.c - the frames and their CRCs.
 *
 * The CRCs are those of plain C, in integers, without vector units. The same CRCs were found
 * - by `tia --checksum` with the scenes as files, see tests/quick/benchmark: another way through the program;
 * - for "spans" by the definition, `tia-compare --exact -s 1920x1080`: no pixel differs from the exact picture;
 * - with each vector instruction set and number of threads: the benchmark itself compares all of them;
 * - in builds for ARM, AArch64 and big-endian s390x, in QEMU.
 * The pictures were looked at. */
#include "benchmark.h"

#include <stddef.h>

const struct benchmark_frame benchmark_frames[BENCHMARK_FRAMES] = {
    {"spans", 1920, 1080, NULL, 0xf9ceb3df},
    {"rays", 320, 180, benchmark_rays, 0x575548ef},
    {"paths", 128, 96, benchmark_paths, 0x6207f452},
    {"shadows", 640, 360, benchmark_shadows, 0x1d2d37db},
};
