/* against.h - compares a picture of the library with the oracle's, pixel by pixel. */
#ifndef TESTS_AGAINST_H
#define TESTS_AGAINST_H

#include "common/corpus/measure.h"
#include "oracle/oracle.h"

#include <inttypes.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define AGAINST_NOTES 8
#define AGAINST_REACH 1e-9 /* in pixels: a thousand times double's rounding errors, far below those of q16 */

/* A pixel that differs. */
struct against_note {
    struct measure_pixel got;
    struct oracle_pixel want;
};

struct against {
    struct tally tally;
    uint64_t undecided; /* flips that lie within AGAINST_REACH of a boundary */
    double margin;      /* largest error of the pixels that are off by one level without a flip */
    unsigned note_count;
    struct against_note notes[AGAINST_NOTES];
};

struct against_comparison {
    const struct measure *what;
    struct against *out; /* an array with an element for each core */
    pthread_mutex_t lock;
};

static inline void against_add(struct against *sum, const struct against *part)
{
    tally_add(&sum->tally, &part->tally);
    sum->undecided += part->undecided;
    sum->margin = part->margin > sum->margin ? part->margin : sum->margin;
    for (unsigned i = 0; i < part->note_count && sum->note_count < AGAINST_NOTES; i++)
        sum->notes[sum->note_count++] = part->notes[i];
}

static inline void against_differs(void *arg, unsigned core, enum verdict verdict, const struct measure_pixel *want,
                                   const struct measure_pixel *got)
{
    struct against_comparison *c = arg;
    const struct measure *what = c->what;
    struct against one = {.note_count = 1, .notes = {{.got = *got}}};
    struct oracle_pixel *pixel = &one.notes[0].want;

    *pixel = oracle_pixel(what->scene, what->width, what->height, want->x, want->y, what->dither);
    one.margin = verdict == ONE_LEVEL ? pixel->margin : 0;
    one.undecided =
        verdict == FLIP && oracle_undecided(what->scene, what->width, what->height, want->x, want->y, AGAINST_REACH);
    (void)pthread_mutex_lock(&c->lock);
    against_add(&c->out[core], &one);
    (void)pthread_mutex_unlock(&c->lock);
}

/* Draws `what` with its cores, and once with the oracle. Returns a negative tia_status if it cannot be drawn. */
static inline int against_oracle_with(struct measure what, struct against out[])
{
    struct against_comparison comparison = {&what, out, PTHREAD_MUTEX_INITIALIZER};
    struct tally tallies[MEASURE_CORES];

    memset(out, 0, what.core_count * sizeof *out);
    what.reference = &oracle_core;
    what.differs = against_differs;
    what.arg = &comparison;
    int status = measure(&what, tallies);
    for (unsigned i = 0; !status && i < what.core_count; i++)
        out[i].tally = tallies[i];
    return status;
}

static inline int against_oracle(const struct tia_core *core, const struct tia_scene *scene, unsigned width,
                                 unsigned height, bool dither, const struct tia_workers *workers, struct against *out)
{
    return against_oracle_with((struct measure){.scene = scene,
                                                .width = width,
                                                .height = height,
                                                .dither = dither,
                                                .cores = {core},
                                                .core_count = 1,
                                                .workers = workers},
                               out);
}

/* Prints the notes if the environment variable VERBOSE is set. */
static inline void against_list(const char *name, const struct against *against)
{
    for (unsigned i = 0; i < against->note_count && getenv("VERBOSE"); i++) {
        const struct measure_pixel *got = &against->notes[i].got;
        const struct oracle_pixel *want = &against->notes[i].want;
        printf("%s (%u, %u): colour %04x object %" PRId32 " lights %" PRIx32 ", oracle %04x %" PRId32 " (%" PRId32
               ") %" PRIx32 "; margin %g depth %g\n",
               name, got->x, got->y, (unsigned)got->colour, (int32_t)got->object, got->path_hash,
               (unsigned)want->colour, (int32_t)want->sphere, (int32_t)want->object, want->path_hash, want->margin,
               want->depth);
    }
}

#endif
