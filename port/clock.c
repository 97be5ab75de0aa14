#include "clock.h"

#include <time.h>

uint64_t clock_now_us(void)
{
    struct timespec now;
    (void)clock_gettime(CLOCK_MONOTONIC, &now);
    return (uint64_t)now.tv_sec * 1000000u + (uint64_t)now.tv_nsec / 1000u;
}

static uint64_t now_us(void *ctx)
{
    (void)ctx;
    return clock_now_us();
}

const struct tia_clock clock_monotonic = {now_us};

int clock_left_ms(uint64_t end_us)
{
    uint64_t now = clock_now_us();

    return now < end_us ? (int)((end_us - now) / 1000) : 0;
}
