/* Pictures of random scenes with solids, tori and rounded boxes: by the vector units, and against the oracle. */
#include "check.h"
#include "common/corpus/corpus_rays.h"
#include "simd_frames_all.h"
#include "with_hierarchy.h"

#include <math.h>
#include <string.h>
#include <tia/tia.h>

#ifdef TIA_HAVE_F64
#include "against_scenes.h"
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
static void add_all(struct corpus_rays *c, uint64_t seed)
{
    corpus_add_solids(c, seed);
    corpus_add_rings(c, seed);
    c->scene.camera.samples = 1;
}

TEST(pictures_are_those_of_the_oracle)
{
    against_scenes(&tia_core_f64, check_count(24), 96, 72, add_all, 1e-4, 99.99);
    against_scenes(&tia_core_q16, check_count(24), 96, 72, add_all, 1e-2, 99.99);
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
