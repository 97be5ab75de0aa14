/* arithmetic.h - the builds of the core that this program is linked with. */
#ifndef TOOLS_TIA_ARITHMETIC_H
#define TOOLS_TIA_ARITHMETIC_H

#include <tia/render.h>

/* "q16" or "f64"; NULL when there is no such build. */
const struct tia_core *arithmetic_called(const char *name);

#endif
