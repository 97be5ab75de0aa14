/* versatilepb.c - Arm Versatile/PB: ARM926EJ-S, PL110. Addresses and bits: Arm DUI 0225. */
#include "panel_board.h"

enum {
    SYSTEM = 0x10000000,
    SYS_LOCK = 0x20,
    SYS_RESETCTL = 0x40,
    SYS_CLCD = 0x50,
    SYS_24MHZ = 0x5c,
    UNLOCK = 0xa05f,
    RESET = 1 << 8
};

/* Selects 5:6:5: the PL110 itself has no RGB565, so a multiplexer behind it rearranges its 16 bits. */
static void select_rgb565(void)
{
    *panel_board_register(SYSTEM, SYS_CLCD) = 3;
}

/* Restarts the board, which cannot switch itself off. */
static void reset(void)
{
    *panel_board_register(SYSTEM, SYS_LOCK) = UNLOCK;
    *panel_board_register(SYSTEM, SYS_RESETCTL) = RESET;
}

const struct panel_board panel_board = {
    .name = "versatilepb",
    .uart = 0x101f1000,
    .panel = 0x10120000,
    .keyboard = 0x10006000,
    .counter = SYSTEM + SYS_24MHZ,
    .panel_format = 4 << 1, /* 16 bits a pixel */
    .prepare_panel = select_rgb565,
    .switch_off = reset,
};
