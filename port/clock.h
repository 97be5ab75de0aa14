/* clock.h - tia_clock on CLOCK_MONOTONIC, which the kernel also uses for input and flip events. */
#ifndef PORT_CLOCK_H
#define PORT_CLOCK_H

#include <tia/port.h>

extern const struct tia_clock clock_monotonic; /* ignores its context */

uint64_t clock_now_us(void);

/* Returns the milliseconds until `end_us`, below 2^31; 0 when it is past. */
int clock_left_ms(uint64_t end_us);

#endif
