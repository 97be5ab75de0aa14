/* simd_used.h - for tests of the bounds of src/simd/span: the fraction of a bound that errors use. */
#ifndef TESTS_SIMD_USED_H
#define TESTS_SIMD_USED_H

#include <math.h>

#include "check.h"
#include "random.h"

typedef long double real;

/* The largest fraction of a bound that an error has used, and the number of values tried. */
struct used {
    const char *name;
    double most;
    unsigned long tried;
};

static inline void use(struct used *u, real error, real bound)
{
    double part = (double)(fabsl(error) / bound);

    u->tried++;
    u->most = bound > 0 || error != 0 ? (part > u->most || isnan(part) ? part : u->most) : u->most;
}

static inline void check_within(const struct used *used)
{
    printf("# %-22s %9lu values, the worst has %.3f of its bound\n", used->name, used->tried, used->most);
    CHECK_MSG(used->most <= 1, "%s: %g times its bound", used->name, used->most);
}

/* Checks that more than 1000 values were tried for each bound, and that none exceeds it. */
static inline void check_used(const struct used *used, int count)
{
    for (int i = 0; i < count; i++) {
        check_within(&used[i]);
        CHECK_MSG(used[i].tried > 1000, "%s: only %lu were tried", used[i].name, used[i].tried);
    }
}

/* Checks that no value exceeds its bound, and that for each bound the largest value is more than a tenth of it. */
static inline void check_tight(const struct used *used, int count)
{
    for (int i = 0; i < count; i++) {
        check_within(&used[i]);
        CHECK_MSG(used[i].most > .1, "%s: no value has more than %g of its bound", used[i].name, used[i].most);
    }
}

#endif
