/* arithmetic.h - the arithmetics that this program is linked with. */
#ifndef TOOLS_TIA_ARITHMETIC_H
#define TOOLS_TIA_ARITHMETIC_H

#include <tia/integrator.h>
#include <tia/render.h>

/* Returns the core called "q16", "f64", ...; NULL when this program lacks it. */
const struct tia_core *arithmetic_called(const char *name);

/* Returns the reason why no core has that name. */
const char *arithmetic_missing(const char *name);

/* Returns the fixed-point core with an observer of rays, for views; NULL when this program lacks it. */
const struct tia_core *arithmetic_watched(void);

/* Returns the estimator of one of these cores; NULL for other cores, such as those of views. */
const struct tia_estimator *arithmetic_estimator(const struct tia_core *core);

#endif
