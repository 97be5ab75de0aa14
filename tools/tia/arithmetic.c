#include "arithmetic.h"

#include <string.h>
#include <tia/debug.h>

/* Cores of the linked libraries. The Makefile defines TIA_LINKED_... for this file alone, one for each library. */
static const struct tia_core *const cores[] = {
    &tia_core_q16,
#ifdef TIA_LINKED_F64
    &tia_core_f64,
    &tia_core_f32,
#endif
#ifdef TIA_LINKED_F128
    &tia_core_f128,
#endif
};

const struct tia_estimator *arithmetic_estimator(const struct tia_core *core)
{
#ifdef TIA_LINKED_F64
    if (core == &tia_core_f64)
        return &tia_estimator_f64;
    if (core == &tia_core_f32)
        return &tia_estimator_f32;
#endif
#ifdef TIA_LINKED_F128
    if (core == &tia_core_f128)
        return &tia_estimator_f128;
#endif
    return core == &tia_core_q16 ? &tia_estimator_q16 : NULL;
}

const struct tia_core *arithmetic_called(const char *name)
{
    for (size_t i = 0; i < sizeof cores / sizeof cores[0]; i++)
        if (strcmp(cores[i]->name, name) == 0)
            return cores[i];
    return NULL;
}

const char *arithmetic_missing(const char *name)
{
    bool finest = strcmp(name, "f128") == 0;

    if (!finest && strcmp(name, "f64") != 0 && strcmp(name, "f32") != 0)
        return "not q16, f32, f64 or f128";
#if defined TIA_HAVE_F64 && !defined TIA_HAVE_F128
    if (finest)
        return "this build has no numbers of 113 bits";
#endif
#ifdef TIA_HAVE_F64
    return "not built in (make builds it)";
#else
    return "this build has q16 only (make F64=yes)";
#endif
}

const struct tia_core *arithmetic_watched(void)
{
#ifdef TIA_LINKED_WATCHED
    return &tia_core_watched;
#else
    return NULL;
#endif
}
