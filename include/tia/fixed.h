/* fixed.h - the number formats of the public interface.
 *
 *   tia_q16     Q16.16, two's complement: 1.0 is 65536, the range is [-32768, 32768)
 *   tia_q30     Q2.30, two's complement:  1.0 is 2^30,  the range is [-2, 2)
 *   tia_rgb565  one pixel: red in bits 15-11, green in 10-5, blue in 4-0, host byte order
 *
 * The conversion macros are for constants only: the compiler evaluates them, so no floating point ends up in the
 * program. Where a double has 32 bits, as on AVR, their results have only 24 significant bits: write integers there
 * instead, as tia-compile does.
 */
#ifndef TIA_FIXED_H
#define TIA_FIXED_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef int32_t tia_q16;
typedef int32_t tia_q30;
typedef uint16_t tia_rgb565;

#define TIA_Q16_ONE 65536
#define TIA_Q30_ONE 1073741824

/* A constant as Q16.16, rounded to nearest, ties away from zero: TIA_Q16(-1.5) is -98304. */
#define TIA_Q16(x) ((tia_q16)((x)*65536.0 + ((x) < 0 ? -0.5 : 0.5)))
/* A constant as Q2.30, rounded likewise. */
#define TIA_Q30(x) ((tia_q30)((x)*1073741824.0 + ((x) < 0 ? -0.5 : 0.5)))

/* The result of every library function that can fail: 0 is success, errors are negative.
 *
 * A call with an invalid argument returns TIA_ERR_ARGUMENT and changes nothing, unless the function's comment names
 * another result. Invalid arguments are NULL where the comment does not allow it, memory that is not aligned as
 * required, and a number, an enum or a tile out of its range. For an invalid argument, functions without a status
 * return SIZE_MAX as a number of bytes, TIA_NO_OBJECT as an object, TIA_NO_LIGHT as a light, and 0, false or NULL
 * otherwise; functions without a result do nothing. docs/library.md lists errors that no call detects. */
enum tia_status {
    TIA_OK = 0,
    TIA_HIDDEN = 1,           /* not an error: another program has the display at the moment */
    TIA_STOPPED = 2,          /* not an error: the caller's `stop` returned true, see tia/job.h */
    TIA_BUSY = 3,             /* not an error: a display is still showing a picture, see tia/port.h */
    TIA_ERR_ARGUMENT = -1,    /* a size, a tile, an enum or a pointer outside the documented range */
    TIA_ERR_RANGE = -2,       /* a scene value outside its range, which tia_scene_check reports */
    TIA_ERR_MEMORY = -3,      /* the caller's memory is too small */
    TIA_ERR_DEVICE = -4,      /* a port's device failed; the port's context has the reason */
    TIA_ERR_UNSUPPORTED = -5, /* the device cannot do this */
    TIA_ERR_DAMAGED = -6      /* memory or pixels are not what they were or must be, see tia/trust.h */
};

#ifdef __cplusplus
}
#endif

#endif
