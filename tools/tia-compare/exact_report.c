#include "exact_report.h"

#include <inttypes.h>
#include <stdio.h>

#include "report.h"

/* Prints a row for each drawer that drew; the first one also has the precisions and ties. */
static void table_rows(const struct exact_report *report, const char *frame, const char *size,
                       const struct exact_tally *tally)
{
    for (unsigned n = 0; n < report->what->drawer_count; n++) {
        if (n && !tally->by[n].pixels)
            continue;
        printf("%-12s %9s %6s %10" PRIu64 " %7" PRIu64, n ? "" : frame, n ? "" : size, report->what->drawers[n].name,
               tally->by[n].pixels, tally->by[n].differ);
        for (unsigned i = 0; i < EXACT_STAGES && !n; i++)
            printf(" %*" PRIu64, i ? 7 : 10, tally->stage[i]);
        if (!n)
            printf(" %7" PRIu64, tally->ties);
        putchar('\n');
    }
}

static void json_tally(const struct exact_report *report, const struct exact_tally *tally)
{
    printf("\"pixels\": %" PRIu64 ", \"bits\": {", tally->pixels);
    for (unsigned i = 0; i < EXACT_STAGES; i++)
        printf("%s\"%u\": %" PRIu64, i ? ", " : "", 64u << i, tally->stage[i]);
    printf("}, \"ties\": %" PRIu64 ", \"drawn\": {", tally->ties);
    for (unsigned n = 0; n < report->what->drawer_count; n++)
        printf("%s\"%s\": {\"pixels\": %" PRIu64 ", \"differ\": %" PRIu64 "}", n ? ", " : "",
               report->what->drawers[n].name, tally->by[n].pixels, tally->by[n].differ);
    printf("}}");
}

void exact_report_begin(const struct exact_report *report)
{
    if (report->json)
        printf("{\"reference\": \"exact\", \"frames\": [");
    else
        printf("%-12s %9s %6s %10s %7s %10s %7s %7s %7s %7s\n", "frame", "size", "", "pixels", "differ", "64 bits",
               "128", "256", "512", "ties");
}

void exact_report_frame(struct exact_report *report, const char *name, const struct exact_measure *frame,
                        const struct exact_tally *tally)
{
    char size[24];

    (void)snprintf(size, sizeof size, "%ux%u", frame->width, frame->height);
    if (report->json && !report->summary) {
        printf("%s\n{\"frame\": ", report->frames > 0 ? "," : "");
        report_json_string(name);
        printf(", \"width\": %u, \"height\": %u, ", frame->width, frame->height);
        json_tally(report, tally);
    } else if (!report->summary) {
        table_rows(report, name, size, tally);
    }
    exact_tally_add(&report->sum, tally);
    report->frames++;
    (void)fflush(stdout);
}

void exact_report_end(const struct exact_report *report)
{
    char name[24];

    if (report->json) {
        printf("],\n\"frame_count\": %u, \"sum\": {", report->frames);
        json_tally(report, &report->sum);
        printf("}\n");
        return;
    }
    (void)snprintf(name, sizeof name, "%u frames", report->frames);
    table_rows(report, name, "", &report->sum);
    printf(
        "\nThe reference is the exact picture. 64 bits, 128, ...: the precision that decided a pixel; ties: pixels in\n"
        "which two sides of a comparison count as equal.\n");
}
