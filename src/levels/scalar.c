/* scalar.c - plain C: it leaves spans as they are, and draws rays in double precision, one at a time. */
#include "level.h"

extern const struct tia_level tia_level_scalar;
extern const struct sure_kernels tia_sure_scalar;
const struct tia_level tia_level_scalar = {"scalar",
                                           &tia_level_entries,
                                           &span_kernels_plain,
                                           {NULL, &tia_level_rays, &tia_level_samples},
                                           NULL,
                                           &tia_sure_scalar,
                                           NULL};
