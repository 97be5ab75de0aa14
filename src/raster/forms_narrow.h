/* forms_narrow.h - linear functions of the pixel in 64 bits, for polygons within tia_raster_grid.narrow. */
#ifndef TIA_RASTER_FORMS_NARROW_H
#define TIA_RASTER_FORMS_NARROW_H

#include <tia/raster.h>

#include "math/wide.h"

#define FORM(name) narrow_##name
typedef int64_t narrow_number;

static inline int64_t narrow_product(int64_t a, int64_t b)
{
    return a * b;
}

static inline int64_t narrow_times(int64_t a, int64_t b)
{
    return a * b;
}

static inline int64_t narrow_sum(int64_t a, int64_t b)
{
    return a + b;
}

static inline int64_t narrow_difference(int64_t a, int64_t b)
{
    return a - b;
}

static inline bool narrow_is_negative(int64_t a)
{
    return a < 0;
}

static inline int narrow_sign(int64_t a)
{
    return (a > 0) - (a < 0);
}

static inline wide narrow_long(int64_t a)
{
    return wide_product(a, 1);
}

/* Returns a.q, which may need more than 64 bits. Components are below 2^62 in magnitude. */
static inline wide narrow_determinant(const int64_t a[3], const int64_t q[3])
{
    return wide_dot(a, q);
}

#include "forms.h"
#undef FORM

#endif
