/* cpu.h - the processor's name. */
#ifndef TOOLS_BENCHMARK_CPU_H
#define TOOLS_BENCHMARK_CPU_H

#include <stddef.h>

/* Writes the name of the processor, or of the board, as Linux tells it; "unknown" if it does not. */
void benchmark_cpu(char *name, size_t size);

#endif
