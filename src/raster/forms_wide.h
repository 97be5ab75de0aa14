/* forms_wide.h - linear functions of the pixel in 128 bits. */
#ifndef TIA_RASTER_FORMS_WIDE_H
#define TIA_RASTER_FORMS_WIDE_H

#include <tia/raster.h>

#include "math/wide.h"

#define FORM(name) wide_##name
typedef wide wide_number;

static inline wide wide_long(wide a)
{
    return a;
}

static inline wide wide_determinant(const wide a[3], const int64_t q[3])
{
    return wide_sum(wide_sum(wide_times(a[0], q[0]), wide_times(a[1], q[1])), wide_times(a[2], q[2]));
}

#include "forms.h"
#undef FORM

#endif
