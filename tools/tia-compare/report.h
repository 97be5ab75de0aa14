/* report.h - the numbers of tia-compare as a table or as JSON, on standard output. */
#ifndef TIA_COMPARE_REPORT_H
#define TIA_COMPARE_REPORT_H

#include "common/corpus/measure.h"

struct report {
    bool json, summary;
    const struct measure *what; /* has the names of the reference and the cores */
    unsigned frames;            /* number of frames so far */
    struct tally sums[MEASURE_CORES];
};

void report_begin(struct report *report);
void report_frame(struct report *report, const char *name, unsigned width, unsigned height,
                  const struct tally *tallies);
void report_end(struct report *report);

/* Prints a text as a JSON string: a file's name can contain any bytes. */
void report_json_string(const char *text);

#endif
