/* noinline.h - NOINLINE marks functions that are not inlined: so their arrays stay off the stack during other calls, or
 * flash has them once. */
#ifndef TIA_MATH_NOINLINE_H
#define TIA_MATH_NOINLINE_H

#if defined(__GNUC__)
#define NOINLINE __attribute__((noinline))
#else
#define NOINLINE
#endif

#endif
