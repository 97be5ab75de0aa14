/* benchmark.h - --benchmark: measures this machine. */
#ifndef TOOLS_TIA_BENCHMARK_H
#define TOOLS_TIA_BENCHMARK_H

#include "options.h"

/* Checks the options that --benchmark allows. Returns EXIT_FINE, or EXIT_USAGE after a message. */
int benchmark_options(const struct options *options);

/* Runs the benchmark and prints its table. Returns the exit status, after a message if it is not 0. */
int benchmark(const struct options *options);

#endif
