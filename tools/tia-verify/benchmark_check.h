/* benchmark_check.h - verifies lines of tia --benchmark. */
#ifndef TOOLS_VERIFY_BENCHMARK_CHECK_H
#define TOOLS_VERIFY_BENCHMARK_CHECK_H

#include <tia/simd.h>

/* Verifies a line; or each line of a file, or of standard input for "-", that is one. Draws all frames again, with that
 * instruction set and number of threads. Returns a status of tia/checking.h; if it is CHECK_FAILED, after a message. */
int benchmark_check(const char *line_or_path, const struct tia_simd *simd, unsigned threads);

#endif
