/* Random scenes, q16 and f64, against the oracle.
 *
 *     test_accuracy [SCENES [SEED]]    default 8 and 1; with VERBOSE set, pixels that differ are listed
 *
 * q16 draws the exact picture, and f64 evaluates the oracle's formulas in another order, so both may differ where the
 * oracle's own value lies within the rounding errors of double precision of a boundary, and nowhere else.
 */
#include "against.h"
#include "check.h"
#include "common/corpus/corpus.h"
#include "common/thread_pool.h"

#include <stdlib.h>

/* The largest margin, in levels. The ground's hits have the worst of double's errors: t = tca - sqrt(r^2 - d2) with
 * terms of 1e8 has an absolute error of some 1e8 2^-53 / 1e2 = 1e-10, a normal the same, and 63 levels make 1e-8 of
 * it. */
#define MARGIN 1e-8

static struct threads *pool;
static unsigned scene_count = 8;
static uint64_t seed = 1;

static uint64_t wrong(const struct against *a)
{
    return a->tally.pixels - a->tally.identical;
}

static void tell(const struct tia_core *core, bool dither, const struct against *sum)
{
    const struct tally *t = &sum->tally;

    printf("%s%s: %u scenes, %ju pixels, %ju identical, %ju one level, %ju flips (%ju undecided), %ju stray, margin "
           "%g\n",
           core->name, dither ? " dithered" : "", scene_count, (uintmax_t)t->pixels, (uintmax_t)t->identical,
           (uintmax_t)t->one, (uintmax_t)t->flips, (uintmax_t)sum->undecided, (uintmax_t)t->stray, sum->margin);
}

/* Draws scene number i by all cores, and adds the results to their sums. No frame may have fewer than 99.99 % identical
 * pixels. */
static void compare(unsigned i, struct measure what, struct against sums[])
{
    struct against all[MEASURE_CORES];
    struct corpus_scene c;
    char name[32];

    corpus_random(&c, seed, i);
    what.scene = &c.scene;
    what.width = c.width;
    what.height = c.height;
    CHECK_EQ(against_oracle_with(what, all), TIA_OK);
    for (unsigned k = 0; k < what.core_count; k++) {
        const struct against *a = &all[k];
        CHECK_MSG(wrong(a) * 10000 <= a->tally.pixels, "scene %u: %ju of %ju pixels differ", i, (uintmax_t)wrong(a),
                  (uintmax_t)a->tally.pixels);
        (void)snprintf(name, sizeof name, "%s scene %u", what.cores[k]->name, i);
        against_list(name, a);
        against_add(&sums[k], a);
    }
}

static void check_sum(const struct against *a)
{
    CHECK_EQ(a->tally.flips, a->undecided);
    CHECK(a->tally.flips * 1000000 <= a->tally.pixels);
    CHECK_EQ(a->tally.stray, 0);
    CHECK_MSG(a->margin < MARGIN, "a colour is off by more than %g levels", a->margin);
}

/* Compares all scenes; the oracle is slow, so each of its pictures is compared with both cores. */
static void compare_all(bool dither)
{
    struct measure what = {
        .dither = dither, .cores = {&tia_core_q16}, .core_count = 1, .workers = threads_workers(pool)};
    struct against sums[MEASURE_CORES] = {0};

#ifdef TIA_HAVE_F64
    what.cores[what.core_count++] = &tia_core_f64;
#endif
    for (unsigned i = 0; i < scene_count; i++)
        compare(i, what, sums);
    for (unsigned k = 0; k < what.core_count; k++) {
        tell(what.cores[k], dither, &sums[k]);
        check_sum(&sums[k]);
    }
}

TEST(they_draw_what_the_oracle_draws)
{
    compare_all(false);
}
TEST(they_dither_like_the_oracle)
{
    compare_all(true);
}

int main(int argc, char **argv)
{
    scene_count = (unsigned)check_number(argc, argv, 1, scene_count);
    seed = check_number(argc, argv, 2, seed);
    pool = threads_create(threads_processors());
    RUN(they_draw_what_the_oracle_draws);
    RUN(they_dither_like_the_oracle);
    threads_destroy(pool);
    return check_status();
}
