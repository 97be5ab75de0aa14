/* line.h - the benchmark's result as one line of text, see docs/verify.md. */
#ifndef TOOLS_BENCHMARK_LINE_H
#define TOOLS_BENCHMARK_LINE_H

#include <stdbool.h>
#include <stddef.h>

#include "benchmark.h"

#define BENCHMARK_WORD "tia-benchmark " /* begins each line */
#define BENCHMARK_LINE ((size_t)16384)  /* longest line with its NUL, bytes */
#define BENCHMARK_WHY 256
#define BENCHMARK_ROWS 128

/* The scores of an instruction set with a number of threads, in frames per 1000 seconds. 0: no score. */
struct benchmark_row {
    char level[8]; /* "plain", or the name of the instruction set */
    unsigned threads;
    uint32_t rates[BENCHMARK_FRAMES];
};

struct benchmark_line {
    unsigned set, definition;
    char version[32];                          /* of tia */
    char cpu[64], machine[32], compiler[64];   /* printable ASCII without quotation marks and backslashes */
    bool by_frames;                            /* each score is of a fixed number of frames */
    uint32_t each;                             /* that number, or the milliseconds for each score */
    unsigned threads;                          /* most threads of a row */
    uint32_t crcs[BENCHMARK_FRAMES];           /* of all drawn frames */
    struct benchmark_row rows[BENCHMARK_ROWS]; /* by instruction set, "plain" first, then by threads, 1 first */
    unsigned row_count;
};

/* Returns the geometric mean of the rates, rounded down: the largest n with n^4 <= a b c d. */
uint32_t benchmark_total(const uint32_t rates[BENCHMARK_FRAMES]);

/* Copies a text into a field of size[`size`] bytes: other characters than the field can have become spaces, and several
 * spaces one. */
void benchmark_set_text(char *field, size_t size, const char *text);

/* Prints the line, without line feed, into text[BENCHMARK_LINE]. Returns its length. */
size_t benchmark_print(const struct benchmark_line *line, char *text);

/* Parses a line, without line feed, in the spelling of benchmark_print alone, and verifies its check word and totals,
 * but not its CRCs. False, with the reason in why[BENCHMARK_WHY]: not valid. */
bool benchmark_parse(struct benchmark_line *line, const char *text, size_t length, char *why);

#endif
