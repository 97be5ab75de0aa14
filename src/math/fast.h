/* fast.h - the first header of the few files whose code runs for each pixel of a scene of spheres. Where a build asks
 * for small code (-Os), gcc compiles these files for speed, with the inline functions of the headers that follow; not
 * on AVRs, whose flash has no room for that. clang knows no such pragma, and needs it less. */
#ifndef TIA_MATH_FAST_H
#define TIA_MATH_FAST_H

#include "target.h"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC push_options
#if defined(__OPTIMIZE_SIZE__) && !defined(__AVR__)
#pragma GCC optimize("O2")
#endif
#endif

#endif
