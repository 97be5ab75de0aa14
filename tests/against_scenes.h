/* against_scenes.h - random scenes of a kind against the oracle. */
#ifndef TESTS_AGAINST_SCENES_H
#define TESTS_AGAINST_SCENES_H

#include "against.h"
#include "check.h"
#include "common/corpus/corpus_rays.h"
#include "common/thread_pool.h"

/* Draws `count` random scenes, to which `add` has added something. All their pixels must be within `margin`, and the
 * given percentage identical. */
static inline void against_scenes(const struct tia_core *core, unsigned count, unsigned width, unsigned height,
                                  void (*add)(struct corpus_rays *out, uint64_t seed), double margin, double identical)
{
    struct threads *pool = threads_create(threads_processors());
    struct against sum = {0}, a;

    for (unsigned i = 0; i < count; i++) {
        static struct corpus_rays c;
        corpus_random_rays(&c, 3, i);
        add(&c, i);
        CHECK_EQ(against_oracle(core, &c.scene, width, height, false, threads_workers(pool), &a), TIA_OK);
        CHECK_MSG(a.tally.stray == 0 && a.margin < margin, "scene %u: %ju stray, margin %g", i,
                  (uintmax_t)a.tally.stray, a.margin);
        against_add(&sum, &a);
    }
    printf("# %ju of %ju pixels identical, margin %g\n", (uintmax_t)sum.tally.identical, (uintmax_t)sum.tally.pixels,
           sum.margin);
    CHECK_MSG(tally_percent(&sum.tally) >= identical, "%.5f %% identical", tally_percent(&sum.tally));
    threads_destroy(pool);
}

#endif
