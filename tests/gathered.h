/* gathered.h - a small picture of samples, with the guides and squares of each pixel. */
#ifndef TESTS_GATHERED_H
#define TESTS_GATHERED_H

#include <tia/tia.h>

enum { WIDE = 37, HIGH = 23, PIXELS = WIDE * HIGH, COUNT = 16 };
#define ONE 16777216.0

static struct tia_sum sums[PIXELS], got[PIXELS];
static struct tia_guide guides[PIXELS];
static uint64_t squares[PIXELS];
static const struct tia_gathered all = {sums, guides, squares, WIDE};
static const struct tia_tile whole = {0, 0, WIDE, HIGH};

#endif
