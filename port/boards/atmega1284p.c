/* atmega1284p.c - an AVR with 128 KB of flash and 16 KB of RAM; text goes to the first serial line, 8N1 at 38400 baud
 * from a 16 MHz clock. avr-libc's own start-up code sets up .data and .bss. */
#include "board.h"

#include <avr/io.h>
#include <avr/sleep.h>

/* Symbols of avr-libc's linker script: the end of the variables, and the last byte of RAM, from which the stack grows
 * down. There is no heap. */
extern uint8_t _end[], __stack[];

enum { PAINT = 0xac, BAUD = 16000000 / 16 / 38400 - 1 };

/* Fills the free RAM with PAINT. Runs before main, without a stack frame: the stack is still empty. */
__attribute__((naked, used, section(".init3"))) void paint_stack(void);
void paint_stack(void)
{
    __asm__ volatile("ldi r30, lo8(_end)\n"
                     "ldi r31, hi8(_end)\n"
                     "ldi r24, %0\n"
                     "ldi r25, hi8(__stack)\n"
                     "1: st Z+, r24\n"
                     "cpi r30, lo8(__stack)\n"
                     "cpc r31, r25\n"
                     "brlo 1b\n"
                     "breq 1b\n" ::"M"(PAINT));
}

uint32_t board_stack_used(void)
{
    const volatile uint8_t *byte = _end;
    while (byte <= __stack && *byte == PAINT)
        byte++;
    return (uint32_t)(__stack + 1 - byte);
}

void board_print(const char *text)
{
    UBRR0 = BAUD;
    UCSR0B = _BV(TXEN0);
    for (; *text; text++) {
        while (!(UCSR0A & _BV(UDRE0)))
            ;
        UCSR0A |= _BV(TXC0);
        UDR0 = (uint8_t)*text;
    }
}

/* Waits until all text is sent, then sleeps with interrupts off. Nothing can wake the processor then, so simavr
 * ends. */
void board_exit(int status)
{
    while (UCSR0B && !(UCSR0A & _BV(TXC0)))
        ;
    GPIOR0 = (uint8_t)status;
    for (;;) {
        sleep_enable();
        sleep_cpu();
    }
}

/* Ends the program; avr-libc calls it when main returns. */
void exit(int status);
void exit(int status)
{
    board_exit(status);
}
