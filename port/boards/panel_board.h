/* panel_board.h - Arm boards with a PL110 or PL111 panel and a PL050 keyboard. */
#ifndef PORT_PANEL_BOARD_H
#define PORT_PANEL_BOARD_H

#include "board.h"

#define PANEL_WIDTH 640
#define PANEL_HEIGHT 480

/* A board: the addresses of its devices, and its own functions. Each board's file defines one. */
struct panel_board {
    const char *name;
    uintptr_t uart, panel, keyboard; /* PL011; PL110 or PL111; PL050 */
    uintptr_t counter;               /* a 32-bit counter that counts up at 24 MHz */
    uint32_t panel_format;           /* the LCDControl bits for RGB565 with red in the upper bits */
    void (*prepare_panel)(void);
    void (*switch_off)(void);
};

extern const struct panel_board panel_board;

static inline volatile uint32_t *panel_board_register(uintptr_t base, uintptr_t offset)
{
    return (volatile uint32_t *)(base + offset);
}

/* The panel as a display, double buffered. The context points to a const char *, which receives the reason for a
 * failure. */
extern const struct tia_display panel_display;

/* The keyboard as an input, with the same kind of context. */
extern const struct tia_input panel_keyboard;

#endif
