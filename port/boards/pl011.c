/* pl011.c - the serial line, 115200 8N1, and the other functions of board.h for boards with a panel. */
#include "panel_board.h"

enum {
    UARTDR = 0x00,
    UARTFR = 0x18,
    UARTIBRD = 0x24,
    UARTFBRD = 0x28,
    UARTLCR_H = 0x2c,
    UARTCR = 0x30,
    FR_TXFF = 1 << 5, /* the transmit FIFO is full */
    LCR_8N1_FIFO = 0x70,
    CR_ON = 0x301 /* UART, transmitter and receiver */
};

static volatile uint32_t *uart(uintptr_t offset)
{
    return panel_board_register(panel_board.uart, offset);
}

static void put(char c)
{
    while (*uart(UARTFR) & FR_TXFF) {
    }
    *uart(UARTDR) = (uint8_t)c;
}

void board_print(const char *text)
{
    if ((*uart(UARTCR) & CR_ON) != CR_ON || *uart(UARTIBRD) == 0) {
        *uart(UARTIBRD) = 13; /* 24 MHz / (16 * 115200) = 13 + 1.3/64 */
        *uart(UARTFBRD) = 1;
        *uart(UARTLCR_H) = LCR_8N1_FIFO;
        *uart(UARTCR) = CR_ON;
    }
    for (; *text; text++) {
        if (*text == '\n')
            put('\r');
        put(*text);
    }
}

void board_exit(int status)
{
    if (status) {
        board_print("stopped with status ");
        board_print_number((uint32_t)status);
        board_print("\n");
    }
    panel_board.switch_off();
    for (;;) {
    }
}
