/* clock.h - a tia_clock that reads CLOCK_MONOTONIC, the clock of the kernel's page-flip events and, on request, of its
 * input events. */
#ifndef PORT_CLOCK_H
#define PORT_CLOCK_H

#include <tia/port.h>

extern const struct tia_clock clock_monotonic; /* ignores its context */

/* Returns CLOCK_MONOTONIC in microseconds. */
uint64_t clock_now_us(void);

/* Returns the time until clock_now_us() is `end_us`, in milliseconds, rounded down; 0 once that is past. The result
 * must be below 2^31. */
int clock_left_ms(uint64_t end_us);

#endif
