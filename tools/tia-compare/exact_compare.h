/* exact_compare.h - tia-compare --exact: compares what tia draws with the exact picture of docs/definition.md. */
#ifndef TIA_COMPARE_EXACT_COMPARE_H
#define TIA_COMPARE_EXACT_COMPARE_H

#include "exact_report.h"
#include "options.h"

struct exact_run {
    struct exact_measure what;
    struct exact_report report;
    char first[160]; /* the first pixel of integers that differs; "": none */
};

/* Begins a comparison and its report. `workers` must outlive it. */
void exact_begin(struct exact_run *run, const struct options *options, const struct tia_workers *workers);

/* Compares a picture. Returns 0, or the exit status after an error message. */
int exact_frame(struct exact_run *run, const char *name, const struct tia_scene *scene, unsigned width,
                unsigned height);

/* Prints the totals. Returns 0; or 1 after an error message if a pixel of integers differs. */
int exact_end(const struct exact_run *run);

#endif
