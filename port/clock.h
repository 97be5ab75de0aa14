/* clock.h - tia_clock on CLOCK_MONOTONIC, which the kernel also uses for input and flip events. */
#ifndef PORT_CLOCK_H
#define PORT_CLOCK_H

#include <tia/port.h>

extern const struct tia_clock clock_monotonic; /* ignores its context */

/* Returns CLOCK_MONOTONIC in microseconds. */
uint64_t clock_now_us(void);

/* Returns the whole milliseconds, below 2^31, until clock_now_us() is `end_us`; 0 when that is past. */
int clock_left_ms(uint64_t end_us);

#endif
