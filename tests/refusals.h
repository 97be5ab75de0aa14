/* refusals.h - a scene that is accepted. A case changes one part of it and checks the result of tia_scene_check. */
#ifndef TESTS_REFUSALS_H
#define TESTS_REFUSALS_H

#include <tia/bvh.h>
#include <tia/motion.h>

#include "check.h"

#define FAR "every point must be nearer to the eye than 32768"

static struct tia_scene scene;

static inline void check_accepted(void)
{
    CHECK_EQ(tia_scene_check(&scene, NULL), TIA_OK);
}

static inline void check_refused(const char *thing, uint32_t index, const char *field, const char *rule)
{
    struct tia_fault f = {"", 0, "", ""};

    CHECK_EQ(tia_scene_check(&scene, NULL), TIA_ERR_RANGE);
    CHECK_EQ(tia_scene_check(&scene, &f), TIA_ERR_RANGE);
    CHECK_MSG(!strcmp(f.thing, thing) && f.index == index && !strcmp(f.field, field) && !strcmp(f.rule, rule),
              "\"%s %u: %s: %s\", not \"%s %u: %s: %s\"", f.thing, (unsigned)f.index, f.field, f.rule, thing,
              (unsigned)index, field, rule);
}

/* Checks that `value`, a field of the scene, must be in first..last. Both ends are accepted; the values next to them
 * and the extremes cause the given fault. The value is then restored. */
static inline void check_range(int32_t *value, int32_t first, int32_t last, const char *thing, uint32_t index,
                               const char *field, const char *rule)
{
    const int32_t good[] = {first, last}, old = *value;
    const int64_t bad[] = {(int64_t)first - 1, (int64_t)last + 1, INT32_MIN, INT32_MAX};

    for (int i = 0; i < 2; i++) {
        *value = good[i];
        check_accepted();
    }
    for (int i = 0; i < 4; i++) {
        if (bad[i] >= INT32_MIN && bad[i] <= INT32_MAX && (bad[i] < first || bad[i] > last)) {
            *value = (int32_t)bad[i];
            check_refused(thing, index, field, rule);
        }
    }
    *value = old;
}

static inline void check_colour(struct tia_rgb *colour, int32_t last, const char *thing, uint32_t index,
                                const char *field, const char *rule)
{
    check_range(&colour->r, 0, last, thing, index, field, rule);
    check_range(&colour->g, 0, last, thing, index, field, rule);
    check_range(&colour->b, 0, last, thing, index, field, rule);
}

#endif
