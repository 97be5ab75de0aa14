/* General scenes: f64 against the oracle, and q16 against f64.
 *
 *     test_rays_accuracy [SCENES [SEED [WIDTH]]]    default 16, 1 and 48; with VERBOSE set, pixels that differ are
 *     listed
 *
 * f64 evaluates the oracle's formulas in another order, so the two may differ where rounding errors in double decide,
 * and nowhere else. At edges the paths of q16 may differ; where they are those of f64, its colours are at most two
 * levels off.
 */
#ifdef TIA_HAVE_F64
#include "against.h"
#include "check.h"
#include "common/corpus/corpus_rays.h"
#include "common/thread_pool.h"

#include <stdlib.h>
#include <tia/bvh.h>
#include <tia/debug.h>

static struct threads *pool;
static unsigned scene_count = 16, width = 48;
static uint64_t seed = 1;

/* Returns scene number i and the height of its picture. Scenes from scene_count on are the first ones again, with
 * holes; every second scene has a hierarchy. */
static unsigned scene_at(struct corpus_rays *c, unsigned i)
{
    static uint64_t memory[1 << 13];

    corpus_random_rays(c, seed, i % scene_count);
    if (i >= scene_count)
        corpus_add_opacity(c, i);
    if (i % 2 > 0)
        CHECK_EQ(tia_bvh_build(&c->scene.bvh, memory, sizeof memory, NULL, &c->scene, NULL), TIA_OK);
    return width * c->height / c->width;
}

/* Largest margin of f64: an error of 1e-12 at the first hit grows with each bounce on a round object, some hundredfold;
 * a highlight's exponent of 200 and 63 levels make 1e-4 of that at worst. */
#define F64_MARGIN 1e-4

static void check_f64(unsigned first)
{
    struct against sum = {0}, a;
    const struct tally *t = &sum.tally;

    for (unsigned i = first; i < first + scene_count; i++) {
        struct corpus_rays c;
        char name[32];
        unsigned height = scene_at(&c, i);
        CHECK_EQ(against_oracle(&tia_core_f64, &c.scene, width, height, false, threads_workers(pool), &a), TIA_OK);
        CHECK_MSG(a.tally.flips == a.undecided && a.tally.stray == 0 && a.margin < F64_MARGIN,
                  "scene %u: %ju flips, %ju undecided, %ju stray, margin %g", i, (uintmax_t)a.tally.flips,
                  (uintmax_t)a.undecided, (uintmax_t)a.tally.stray, a.margin);
        (void)snprintf(name, sizeof name, "f64 scene %u", i);
        against_list(name, &a);
        against_add(&sum, &a);
    }
    printf("f64: %u scenes, %ju pixels, %ju identical, %ju flips (%ju undecided), %ju stray, margin %g\n", scene_count,
           (uintmax_t)t->pixels, (uintmax_t)t->identical, (uintmax_t)t->flips, (uintmax_t)sum.undecided,
           (uintmax_t)t->stray, sum.margin);
    CHECK(t->flips * 10000 <= t->pixels);
}

TEST(f64_draws_what_the_oracle_draws)
{
    check_f64(0);
}

TEST(f64_draws_holes_as_the_oracle_does)
{
    check_f64(scene_count);
}

static int compare(const struct tia_scene *scene, unsigned height, struct tally tallies[2])
{
    struct measure what = {.scene = scene,
                           .width = width,
                           .height = height,
                           .reference = &tia_core_f64,
                           .cores = {&tia_core_q16, &tia_core_f32},
                           .core_count = 2,
                           .workers = threads_workers(pool)};

    return measure(&what, tallies);
}

static void tell(const char *name, const struct tally *t)
{
    printf("%s: %u scenes, %ju pixels, %.5f %% identical, %ju one level, %ju more, %ju flips, %ju stray, worst %ju on "
           "the same path\n",
           name, scene_count, (uintmax_t)t->pixels, tally_percent(t), (uintmax_t)t->one, (uintmax_t)t->more,
           (uintmax_t)t->flips, (uintmax_t)t->stray, (uintmax_t)t->astray);
}

static void check_q16(unsigned first)
{
    struct tally sums[2] = {{0}}, tallies[2];

    for (unsigned i = first; i < first + scene_count; i++) {
        struct corpus_rays c;
        unsigned height = scene_at(&c, i);
        CHECK_EQ(compare(&c.scene, height, tallies), TIA_OK);
        CHECK_MSG(tallies[0].astray <= 2, "scene %u: %ju levels off on the same path", i, (uintmax_t)tallies[0].astray);
        CHECK_MSG(tally_percent(&tallies[0]) >= 99.9, "scene %u: %.5f %% identical", i, tally_percent(&tallies[0]));
        tally_add(&sums[0], &tallies[0]);
        tally_add(&sums[1], &tallies[1]);
    }
    tell("q16", &sums[0]);
    tell("f32", &sums[1]);
    CHECK_MSG(tally_percent(&sums[0]) >= 99.99, "%.5f %% identical", tally_percent(&sums[0]));
}

TEST(q16_draws_what_f64_draws)
{
    check_q16(0);
}

TEST(q16_draws_holes_as_f64_does)
{
    check_q16(scene_count);
}

int main(int argc, char **argv)
{
    scene_count = (unsigned)check_number(argc, argv, 1, scene_count);
    seed = check_number(argc, argv, 2, seed);
    width = (unsigned)check_number(argc, argv, 3, width);
    pool = threads_create(threads_processors());
    RUN(f64_draws_what_the_oracle_draws);
    RUN(f64_draws_holes_as_the_oracle_does);
    RUN(q16_draws_what_f64_draws);
    RUN(q16_draws_holes_as_f64_does);
    threads_destroy(pool);
    return check_status();
}
#else
#include "without_f64.h"
#endif
