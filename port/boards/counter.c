/* counter.c - a 64-bit clock from a 32-bit counter, which wraps after 179 s. If the clock is not read for longer, it
 * loses multiples of 179 s, but it never goes back. */
#include "panel_board.h"

#define TICKS_PER_US 24

static struct {
    uint32_t last;
    uint64_t ticks;
} passed;

static uint64_t now_us(void *ctx)
{
    (void)ctx;
    uint32_t now = *panel_board_register(panel_board.counter, 0);
    passed.ticks += now - passed.last;
    passed.last = now;
    return passed.ticks / TICKS_PER_US;
}

const struct tia_clock board_clock = {now_us};
