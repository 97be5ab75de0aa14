/* cortex-m.c - the vector table of an ARMv6-M or ARMv7-M processor. */
#include "board.h"

extern uint32_t board_stack_end[];

static void reset(void)
{
    board_start();
}

static void fault(void)
{
    board_print("fault: the processor stopped the program\n");
    board_exit(70);
}

/* The table that the processor reads at reset. Interrupts stay off, so the table ends with the exceptions. */
struct vector_table {
    uint32_t *stack_end;
    void (*handlers[15])(void); /* exceptions 1 (reset) to 15 */
};

__attribute__((section(".start"), used)) static const struct vector_table vector_table = {
    board_stack_end,
    {reset, fault, fault, fault, fault, fault, 0, 0, 0, 0, fault, fault, 0, fault, fault},
};
