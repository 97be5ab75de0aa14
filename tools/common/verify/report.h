/* report.h - compares rows that were drawn again with stored ones, and reports what differs. */
#ifndef TOOLS_VERIFY_REPORT_H
#define TOOLS_VERIFY_REPORT_H

#include <stdio.h>

#include "choice.h"

struct report {
    FILE *out;
    const char *before;   /* begins each line: "", or "tia-join: " */
    bool quiet;           /* only what differs is printed */
    const char *name;     /* name of the picture */
    const char *unit;     /* what is counted: "rows" */
    const char *done;     /* what was done with it: "drawn again" */
    const char *from;     /* what drew it, for messages; "": not known */
    unsigned pixels;      /* pixels of a row */
    bool film;            /* frames are named */
    uint64_t seen, wrong; /* rows compared; rows that differ */
};

/* Compares a row of `length` bytes. `exact` false: the stored row cannot be the drawn one whatever its bytes are.
 * Prints a line for each of the first rows that differ. */
void report_row(struct report *report, uint32_t frame, unsigned y, const unsigned char *stored,
                const unsigned char *drawn, size_t length, bool exact);

/* Prints "NAME: ", without control characters. */
void report_name(const struct report *report);

/* Prints the result: what was looked at, what differs, and the chance that forged rows are unseen. Returns true if all
 * rows were as drawn. */
bool report_end(const struct report *report, const struct choice *choice);

#endif
