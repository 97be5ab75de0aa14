/* Pictures of random scenes with solids, tori and rounded boxes: by the vector units, and against the oracle. */
#include "check.h"
#include "common/corpus/corpus_rays.h"
#include "common/thread_pool.h"
#include "simd_frames_all.h"
#include "with_hierarchy.h"

#include <math.h>
#include <string.h>
#include <tia/tia.h>

#ifdef TIA_HAVE_F64
#include "against.h"
#endif

static unsigned number;

static void same_picture(const struct tia_scene *with, unsigned unused)
{
    (void)unused;
    simd_frames_check_all(with, 40, 30, number);
}

TEST(vector_units_draw_the_same)
{
    static struct corpus_rays c;

    for (number = 0; number < 12; number++) {
        corpus_random_rays(&c, 5, number);
        corpus_add_solids(&c, number);
        corpus_add_rings(&c, number);
        if (number % 3 == 2)
            corpus_add_opacity(&c, number);
        c.scene.integration.integrator = (enum tia_integrator)(number % 4 == 3 ? number / 4 % 2 + 1 : 0);
        with_hierarchy(&c.scene, same_picture, 0);
    }
}

#ifdef TIA_HAVE_F64
static void against_the_oracle(const struct tia_core *core, double margin, double identical)
{
    static struct corpus_rays c;
    struct threads *pool = threads_create(threads_processors());
    struct against sum = {0}, a;

    for (unsigned i = 0; i < check_count(24); i++) {
        corpus_random_rays(&c, 3, i);
        corpus_add_solids(&c, i);
        corpus_add_rings(&c, i);
        c.scene.camera.samples = 1;
        CHECK_EQ(against_oracle(core, &c.scene, 96, 72, false, threads_workers(pool), &a), TIA_OK);
        CHECK_MSG(a.tally.stray == 0 && a.margin < margin, "scene %u: %ju stray, margin %g", i,
                  (uintmax_t)a.tally.stray, a.margin);
        against_add(&sum, &a);
    }
    printf("# %ju of %ju pixels identical, margin %g\n", (uintmax_t)sum.tally.identical, (uintmax_t)sum.tally.pixels,
           sum.margin);
    CHECK_MSG(tally_percent(&sum.tally) >= identical, "%.5f %% identical", tally_percent(&sum.tally));
    threads_destroy(pool);
}

TEST(pictures_are_those_of_the_oracle)
{
    against_the_oracle(&tia_core_f64, 1e-4, 99.99);
    against_the_oracle(&tia_core_q16, 1e-2, 99.99);
}
#endif

int main(void)
{
    RUN(vector_units_draw_the_same);
#ifdef TIA_HAVE_F64
    RUN_LONG(pictures_are_those_of_the_oracle);
#endif
    return check_status();
}
