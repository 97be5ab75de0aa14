#include "report.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>

static void table_row(const char *frame, const char *size, const char *core, const struct tally *t)
{
    char psnr[16] = "inf";

    if (t->squares > 0)
        (void)snprintf(psnr, sizeof psnr, "%.2f", tally_psnr(t));
    printf("%-12s %9s %4s %10" PRIu64 " %10" PRIu64 " %10.6f %7" PRIu64 " %6" PRIu64 " %6" PRIu64 " %6" PRIu64
           " %5" PRIu64 " %7s\n",
           frame, size, core, t->pixels, t->identical, tally_percent(t), t->one, t->more, t->flips, t->stray,
           t->largest, psnr);
}

static void json_tally(const char *core, const struct tally *t)
{
    printf("\"%s\": {\"pixels\": %" PRIu64 ", \"identical\": %" PRIu64 ", \"identical_percent\": %.7f, "
           "\"one_level\": %" PRIu64 ", \"more\": %" PRIu64 ", \"flips\": %" PRIu64 ", \"more_same_state\": %" PRIu64
           ", \"largest\": %" PRIu64 ", \"largest_same_state\": %" PRIu64 ", \"psnr\": ",
           core, t->pixels, t->identical, tally_percent(t), t->one, t->more, t->flips, t->stray, t->largest, t->astray);
    if (t->squares > 0)
        printf("%.4f}", tally_psnr(t));
    else
        printf("null}");
}

static void json_tallies(const struct report *report, const struct tally *tallies)
{
    for (unsigned i = 0; i < report->what->core_count; i++) {
        (void)fputs(i > 0 ? ", " : "", stdout);
        json_tally(report->what->cores[i]->name, &tallies[i]);
    }
}

void report_json_string(const char *text)
{
    putchar('"');
    for (; *text != '\0'; text++)
        if (*text == '"' || *text == '\\')
            printf("\\%c", *text);
        else if ((unsigned char)*text < ' ')
            printf("\\u%04x", (unsigned char)*text);
        else
            putchar(*text);
    putchar('"');
}

void report_begin(struct report *report)
{
    if (report->json)
        printf("{\"reference\": \"%s\", \"frames\": [", report->what->reference->name);
    else
        printf("%-12s %9s %4s %10s %10s %10s %7s %6s %6s %6s %5s %7s\n", "frame", "size", "", "pixels", "identical",
               "percent", "1 level", "more", "flips", "stray", "worst", "PSNR dB");
}

void report_frame(struct report *report, const char *name, unsigned width, unsigned height, const struct tally *tallies)
{
    char size[24];

    (void)snprintf(size, sizeof size, "%ux%u", width, height);
    if (report->json && !report->summary) {
        printf("%s\n{\"frame\": ", report->frames > 0 ? "," : "");
        report_json_string(name);
        printf(", \"width\": %u, \"height\": %u, ", width, height);
        json_tallies(report, tallies);
        printf("}");
    }
    for (unsigned i = 0; i < report->what->core_count; i++) {
        if (!report->json && !report->summary)
            table_row(i == 0 ? name : "", i == 0 ? size : "", report->what->cores[i]->name, &tallies[i]);
        tally_add(&report->sums[i], &tallies[i]);
    }
    report->frames++;
    (void)fflush(stdout);
}

void report_end(struct report *report)
{
    char name[24];

    if (report->json) {
        printf("],\n\"frame_count\": %u, \"sum\": {", report->frames);
        json_tallies(report, report->sums);
        printf("}}\n");
        return;
    }
    (void)snprintf(name, sizeof name, "%u frames", report->frames);
    for (unsigned i = 0; i < report->what->core_count; i++)
        table_row(i == 0 ? name : "", "", report->what->cores[i]->name, &report->sums[i]);
    printf("\nflips: another object is hit or other lights reach it; stray: off by more than one level, no flip;\n"
           "worst: the largest difference of a channel, in its levels. The reference is %s.\n",
           report->what->reference->name);
}
