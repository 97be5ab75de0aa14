#include "stats.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

void stats_add(struct samples *samples, uint64_t us)
{
    samples->us[samples->count++ % STATS_SAMPLES] = us < UINT32_MAX ? (uint32_t)us : UINT32_MAX;
}

static int compare(const void *left, const void *right)
{
    uint32_t a = *(const uint32_t *)left, b = *(const uint32_t *)right;
    return (a > b) - (a < b);
}

uint32_t stats_percentile(struct samples *samples, unsigned percent)
{
    uint64_t kept = samples->count < STATS_SAMPLES ? samples->count : STATS_SAMPLES;
    if (kept == 0)
        return 0;
    qsort(samples->us, (size_t)kept, sizeof samples->us[0], compare);
    uint64_t rank = (kept * percent + 99) / 100;
    return samples->us[rank > 0 ? rank - 1 : 0];
}

static void print_samples(const char *name, struct samples *samples)
{
    if (samples->count == 0) {
        (void)fprintf(stderr, "\"%s\": {\"p50\": null, \"p95\": null}, ", name);
        return;
    }
    uint32_t p50 = stats_percentile(samples, 50), p95 = stats_percentile(samples, 95);
    (void)fprintf(stderr, "\"%s\": {\"p50\": %" PRIu32 ".%03" PRIu32 ", \"p95\": %" PRIu32 ".%03" PRIu32 "}, ", name,
                  p50 / 1000, p50 % 1000, p95 / 1000, p95 % 1000);
}

void stats_key(struct stats *stats, uint64_t us, bool coarse)
{
    if (us != 0 && (coarse || !stats->answered))
        stats_add(&stats->coarse, us);
    if (us != 0 && !coarse)
        stats_add(&stats->flip, us);
    stats->answered = coarse && (us != 0 || stats->answered);
}

void stats_paced(struct paced *paced, const struct tia_frame *frame, uint64_t now_us)
{
    unsigned level = 0;

    while (level < 4 && frame->block >> (level + 1))
        level++;
    if (frame->moving)
        paced->blocks[level]++;
    if (frame->moving && paced->last_us) {
        paced->sum_us += now_us - paced->last_us;
        paced->count++;
    }
    paced->last_us = frame->moving ? now_us : 0;
}

static void print_rate(const char *name, uint64_t us, uint64_t count)
{
    uint64_t thousandths = us ? (count * UINT64_C(1000000000) + us / 2) / us : 0;

    (void)fprintf(stderr, "\"%s\": %" PRIu64 ".%03" PRIu64 ", ", name, thousandths / 1000, thousandths % 1000);
}

static void print_paced(const struct paced *paced)
{
    if (!paced->asked_us)
        return;
    (void)fputs("\"pace\": {", stderr);
    print_rate("asked", paced->asked_us, 1);
    print_rate("achieved", paced->sum_us, paced->count);
    (void)fputs("\"blocks\": {", stderr);
    for (unsigned i = 0; i < 5; i++)
        (void)fprintf(stderr, "%s\"%u\": %" PRIu64, i ? ", " : "", 1u << i, paced->blocks[i]);
    (void)fputs("}}, ", stderr);
}

/* Prints the drawn pixels as a share of the pixels of all frames. */
static void print_drawn(const struct stats *stats)
{
    uint64_t all = stats->all_pixels ? stats->all_pixels : 1, millionths = stats->pixels * 1000000 / all;

    (void)fprintf(stderr, "\"drawn\": %" PRIu64 ".%06" PRIu64 ", ", millionths / 1000000, millionths % 1000000);
}

int stats_print(struct stats *stats)
{
    (void)fprintf(stderr, "{\"frames\": %" PRIu64 ", ", stats->frames);
    print_samples("frame_ms", &stats->draw);
    print_samples("input_to_flip_ms", &stats->flip);
    print_samples("input_to_coarse_ms", &stats->coarse);
    if (stats->gazes)
        print_drawn(stats);
    print_paced(&stats->paced);
    (void)fprintf(stderr,
                  "\"display\": \"%s\", \"format\": \"%s\", \"size\": \"%ux%u\", \"simd\": \"%s\", \"threads\": %u, "
                  "\"scale_bits\": %d}\n",
                  stats->display, stats->format, stats->width, stats->height, stats->simd ? stats->simd : "plain",
                  stats->threads, stats->scale_bits);
    return fflush(stderr) != 0 || ferror(stderr) != 0 ? -1 : 0;
}
