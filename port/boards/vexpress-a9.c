/* vexpress-a9.c - Arm Versatile Express with the Cortex-A9 tile: PL111. Addresses and bits: Arm
 * DUI 0447 (motherboard) and DUI 0448 (tile). */
#include "panel_board.h"

enum { SYSTEM = 0x10000000, SYS_24MHZ = 0x5c, SYS_CFGCTRL = 0xa4 };

#define CFG_START (1u << 31)
#define CFG_WRITE (1u << 30)
#define CFG_SHUTDOWN (8u << 20)

static void nothing(void) {}

static void shut_down(void)
{
    *panel_board_register(SYSTEM, SYS_CFGCTRL) = CFG_START | CFG_WRITE | CFG_SHUTDOWN;
}

const struct panel_board panel_board = {
    .name = "vexpress-a9",
    .uart = 0x10009000,
    .panel = 0x10020000,
    .keyboard = 0x10006000,
    .counter = SYSTEM + SYS_24MHZ,
    .panel_format = 6 << 1 | 1 << 8, /* 5:6:5 and BGR, without which the PL111 has red at bit 0 */
    .prepare_panel = nothing,
    .switch_off = shut_down,
};
