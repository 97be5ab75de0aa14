/* clock.h - tia_clock on CLOCK_MONOTONIC, the clock of the kernel's input and flip events too. */
#ifndef PORT_COMMON_CLOCK_H
#define PORT_COMMON_CLOCK_H

#include <tia/port.h>

extern const struct tia_clock clock_monotonic; /* its context is not used */

uint64_t clock_now_us(void);

#endif
