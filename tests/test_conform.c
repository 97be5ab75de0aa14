/* test_conform.c - the search of tia-conform for the fewest triangles, with the exact rasteriser made wrong in one rule
 * at a time: what it finds is that rule, by as many triangles as the rule needs. */
#include <string.h>

#include "check.h"
#include "conform/trial.h"

/* Draws by the exact rasteriser after a change of the trial, which `ctx` makes. */
typedef void change(struct triangle *triangle);

static bool draw_changed(void *ctx, const struct trial *trial, struct pixels *pixels)
{
    struct trial changed = *trial;
    change *const *make = ctx;

    for (unsigned i = 0; i < changed.count; i++)
        (*make)(&changed.triangles[i]);
    return trial_exact(NULL, &changed, pixels);
}

/* Ties broken to the left and up: corners moved by less than the distance of a centre from the edges of this test. */
static void shift(struct triangle *triangle)
{
    for (int i = 0; i < 3; i++) {
        triangle->x[i]++;
        triangle->y[i]++;
    }
}

static void less_passes_equal(struct triangle *triangle)
{
    if (triangle->state.depth == TIA_COMPARE_LESS)
        triangle->state.depth = TIA_COMPARE_LEQUAL;
}

static void increments_wrap(struct triangle *triangle)
{
    if (triangle->state.front.zpass == TIA_STENCIL_DECR)
        triangle->state.front.zpass = TIA_STENCIL_DECR_WRAP;
}

static void nothing(struct triangle *triangle)
{
    (void)triangle;
}

/* Returns the number of trials, of 100, that differ; *smallest receives the first finding of fewest triangles. */
static unsigned search(change *make, unsigned step, struct finding *smallest)
{
    static struct pixels exact, found;
    static struct finding finding;
    uint64_t seed = 30;
    unsigned differing = 0, first;

    for (int i = 0; i < 100; i++) {
        struct trial trial;
        memset(&trial, 0, sizeof trial);
        trial_random(&trial, &seed, step);
        CHECK(trial_exact(NULL, &trial, &exact) && draw_changed(&make, &trial, &found));
        if (!trial_differs(&exact, &found, &first))
            continue;
        CHECK(trial_shrink(&trial, draw_changed, &make, &finding));
        if (differing++ == 0 || finding.trial.count < smallest->trial.count)
            *smallest = finding;
    }
    return differing;
}

static void finds(change *make, unsigned step, enum rule rule, unsigned triangles)
{
    static struct finding smallest;

    CHECK(search(make, step, &smallest) > 0);
    CHECK_EQ(smallest.rule, rule);
    CHECK_EQ(smallest.trial.count, triangles);
}

TEST(nothing_differs)
{
    static struct finding smallest;

    CHECK_EQ(search(nothing, 1, &smallest), 0);
}

TEST(ties_are_found)
{
    finds(shift, 256, RULE_TIES, 1);
}

TEST(depth_tests_are_found)
{
    finds(less_passes_equal, 1, RULE_DEPTH, 2);
}

TEST(stencil_operations_are_found)
{
    finds(increments_wrap, 1, RULE_STENCIL, 1);
}

int main(void)
{
    RUN(nothing_differs);
    RUN(ties_are_found);
    RUN(depth_tests_are_found);
    RUN(stencil_operations_are_found);
    return check_status();
}
