/* exact_report.h - the numbers of tia-compare --exact as a table or as JSON, on standard output. */
#ifndef TIA_COMPARE_EXACT_REPORT_H
#define TIA_COMPARE_EXACT_REPORT_H

#include "common/corpus/exact_measure.h"

struct exact_report {
    bool json, summary;
    const struct exact_measure *what; /* has the drawers */
    unsigned frames;                  /* number of frames so far */
    struct exact_tally sum;
};

/* Begins the table, or the JSON object. */
void exact_report_begin(const struct exact_report *report);

/* Prints a picture's rows, unless `summary`, and adds them to the sum. */
void exact_report_frame(struct exact_report *report, const char *name, const struct exact_measure *frame,
                        const struct exact_tally *tally);

/* Ends it with the sum. */
void exact_report_end(const struct exact_report *report);

#endif
