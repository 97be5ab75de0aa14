/* Random scenes, q16 and f64, against the oracle.
 *
 *     test_accuracy [SCENES [SEED]]    default 8 and 1; with VERBOSE set, pixels that differ are listed
 *
 * f64 evaluates the oracle's formulas in another order, so it may differ where the oracle's own value
 * lies within the rounding errors of double precision of a boundary, and nowhere else.
 */
#include "against.h"
#include "check.h"
#include "common/thread_pool.h"
#include "corpus/corpus.h"

#include <stdlib.h>

/* The ground's hits are the worst of double's errors: t = tca - sqrt(r^2 - d2) with terms of 1e8 has an
 * absolute error of some 1e8 2^-53 / 1e2 = 1e-10, a normal the same, and 63 levels make 1e-8 of it. */
#define F64_MARGIN 1e-8

static struct threads *pool;
static unsigned scene_count = 8;
static uint64_t seed = 1;

static uint64_t wrong(const struct against *a)
{
    return a->tally.pixels - a->tally.identical;
}

/* No frame may have fewer than 99.99 % identical pixels. */
static struct against compare_all(const struct tia_core *core, bool dither)
{
    struct against sum = {0}, a;
    const struct tally *t = &sum.tally;

    for (unsigned i = 0; i < scene_count; i++) {
        struct corpus_scene c;
        char name[32];
        corpus_random(&c, seed, i);
        CHECK_EQ(against_oracle(core, &c.scene, c.width, c.height, dither, &threads_workers, pool, &a), TIA_OK);
        CHECK_MSG(wrong(&a) * 10000 <= a.tally.pixels, "scene %u: %ju of %ju pixels differ", i, (uintmax_t)wrong(&a),
                  (uintmax_t)a.tally.pixels);
        (void)snprintf(name, sizeof name, "%s scene %u", core->name, i);
        against_list(name, &a);
        against_add(&sum, &a);
    }
    printf("%s%s: %u scenes, %ju pixels, %ju identical, %ju one level, %ju flips (%ju undecided), %ju stray, margin "
           "%g\n",
           core->name, dither ? " dithered" : "", scene_count, (uintmax_t)t->pixels, (uintmax_t)t->identical,
           (uintmax_t)t->one, (uintmax_t)t->flips, (uintmax_t)sum.undecided, (uintmax_t)t->stray, sum.margin);
    return sum;
}

static void check_q16(bool dither)
{
    struct against a = compare_all(&tia_core_q16, dither);

    CHECK_MSG(wrong(&a) * 100000 <= a.tally.pixels, "%ju of %ju pixels differ", (uintmax_t)wrong(&a),
              (uintmax_t)a.tally.pixels);
    CHECK_MSG(a.tally.flips * 1000000 <= 2 * a.tally.pixels, "%ju flips", (uintmax_t)a.tally.flips);
    CHECK_EQ(a.tally.stray, 0);
}

TEST(q16_draws_what_the_oracle_draws)
{
    check_q16(false);
}
TEST(q16_dithers_like_the_oracle)
{
    check_q16(true);
}

#ifdef TIA_HAVE_F64
static void check_f64(bool dither)
{
    struct against a = compare_all(&tia_core_f64, dither);

    CHECK_EQ(a.tally.flips, a.undecided);
    CHECK(a.tally.flips * 1000000 <= a.tally.pixels);
    CHECK_EQ(a.tally.stray, 0);
    CHECK_MSG(a.margin < F64_MARGIN, "a colour is off by more than %g levels", a.margin);
}

TEST(f64_draws_what_the_oracle_draws)
{
    check_f64(false);
}
TEST(f64_dithers_like_the_oracle)
{
    check_f64(true);
}
#endif

int main(int argc, char **argv)
{
    if (argc > 1)
        scene_count = (unsigned)strtoul(argv[1], NULL, 10);
    if (argc > 2)
        seed = strtoull(argv[2], NULL, 10);
    pool = threads_create(threads_processors());
    RUN(q16_draws_what_the_oracle_draws);
    RUN(q16_dithers_like_the_oracle);
#ifdef TIA_HAVE_F64
    RUN(f64_draws_what_the_oracle_draws);
    RUN(f64_dithers_like_the_oracle);
#endif
    threads_destroy(pool);
    return check_status();
}
