/* board.h - what a program gets on a board without an operating system.
 *
 * The start-up code fills the sections, paints the stack and calls main; when main returns, the
 * board is switched off where it can be, and stops otherwise.
 */
#ifndef PORT_BOARD_H
#define PORT_BOARD_H

#include <tia/port.h>

int main(void);

/* Text for whoever watches: the serial line, or the debugger's console on a microcontroller. */
void board_print(const char *text);
void board_print_number(uint32_t value);
void board_print_hex(uint32_t value); /* eight digits */

/* The end of the program; a debugger is told the status. */
_Noreturn void board_exit(int status);

/* The most bytes of stack that were in use at any time since the start. */
uint32_t board_stack_used(void);

/* Boards with a panel: a 24 MHz counter as the clock. It needs no context. */
extern const struct tia_clock board_clock;

/* What the start-up code calls. */
_Noreturn void board_start(void);

#endif
