#include "arithmetic.h"

#include <string.h>

static const struct tia_core *const cores[] = {
    &tia_core_q16,
#ifdef TIA_HAVE_F64
    &tia_core_f64,
#endif
};

const struct tia_estimator *arithmetic_estimator(const struct tia_core *core)
{
#ifdef TIA_HAVE_F64
    if (core == &tia_core_f64)
        return &tia_estimator_f64;
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
