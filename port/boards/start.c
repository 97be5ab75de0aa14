/* start.c - initialises the memory and calls main, after the processor's own start-up code has set the stack
 * pointer. */
#include "board.h"

/* Symbols that sections.ld defines. */
extern uint32_t board_data_load[], board_data[], board_data_end[], board_bss_end[], board_stack_end[];

#define PAINT 0x5afe57acu

static void fill_sections(void)
{
    uint32_t *to = board_data;
    for (const uint32_t *from = board_data_load; to < board_data_end;)
        *to++ = *from++;
    while (to < board_bss_end)
        *to++ = 0;
}

/* Fills the free stack with PAINT, from the end of .bss to below this function's frame. */
static void paint_stack(void)
{
    volatile uint32_t *here = __builtin_frame_address(0);
    for (volatile uint32_t *word = board_bss_end; word < here - 16; word++)
        *word = PAINT;
}

uint32_t board_stack_used(void)
{
    const volatile uint32_t *word = board_bss_end;
    while (word < board_stack_end && *word == PAINT)
        word++;
    return (uint32_t)(board_stack_end - word) * 4;
}

void board_start(void)
{
    fill_sections();
    paint_stack();
    board_exit(main());
}
