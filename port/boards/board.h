/* board.h - services for a program on a board without an operating system.
 *
 * The start-up code initialises the sections, fills the stack with a pattern and calls main. When main returns, the
 * board switches off, restarts or halts.
 */
#ifndef PORT_BOARD_H
#define PORT_BOARD_H

#include <tia/port.h>

int main(void);

/* Prints to the serial line or, with semihosting, to the debugger's console. */
void board_print(const char *text);
/* Prints a number in decimal. */
void board_print_number(uint32_t value);
/* Prints `value` as eight hexadecimal digits. */
void board_print_hex(uint32_t value);

/* Ends the program; reports the status to the debugger or the emulator, or on the serial line. */
_Noreturn void board_exit(int status);

/* Returns the peak stack use since the start, in bytes. */
uint32_t board_stack_used(void);

/* The clock of boards with a panel, from a 24 MHz counter; ignores its context. */
extern const struct tia_clock board_clock;

/* Initialises the memory and runs main. Called by the processor's own start-up code. */
_Noreturn void board_start(void);

#endif
