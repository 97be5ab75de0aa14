/* arithmetic.h - the arithmetics that this program is linked with. */
#ifndef TOOLS_TIA_ARITHMETIC_H
#define TOOLS_TIA_ARITHMETIC_H

#include <tia/integrator.h>
#include <tia/render.h>

/* The core called "q16", "f64", ...; NULL when this program does not have it. */
const struct tia_core *arithmetic_called(const char *name);

/* Why there is none called so. */
const char *arithmetic_missing(const char *name);

/* The integers with an observer of rays, for views; NULL when this program does not have them. */
const struct tia_core *arithmetic_watched(void);

/* What samples for one of these; NULL for other cores, such as those of views. */
const struct tia_estimator *arithmetic_estimator(const struct tia_core *core);

#endif
