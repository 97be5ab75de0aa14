/* pl050.c - a PS/2 keyboard on a PL050. Registers: Arm DDI 0143. Between two polls, the keyboard itself buffers
 * 16 bytes. */
#include "panel_board.h"
#include "ps2/ps2.h"

enum {
    KMI_CR = 0x00,
    KMI_STAT = 0x04,
    KMI_DATA = 0x08,
    KMI_CLKDIV = 0x0c,
    CR_ENABLE = 1 << 2,
    STAT_RXFULL = 1 << 4,
    STAT_TXEMPTY = 1 << 6,
    CLOCK_DIVISOR = 24 / 8 - 1, /* from 24 MHz to the 8 MHz that the PL050 needs */
    ANSWER_LIMIT_US = 10000000
};

static struct tia_ps2 ps2;

static volatile uint32_t *kmi(uintptr_t offset)
{
    return panel_board_register(panel_board.keyboard, offset);
}

static bool wait_for(uint32_t status, int64_t limit_us)
{
    uint64_t start = board_clock.now_us(NULL);
    while (!(*kmi(KMI_STAT) & status))
        if (limit_us >= 0 && board_clock.now_us(NULL) - start >= (uint64_t)limit_us)
            return false;
    return true;
}

static int keyboard_open(void *ctx)
{
    ps2 = (struct tia_ps2){0};
    *kmi(KMI_CLKDIV) = CLOCK_DIVISOR;
    *kmi(KMI_CR) = CR_ENABLE;
    while (*kmi(KMI_STAT) & STAT_RXFULL)
        (void)*kmi(KMI_DATA);
    bool answered = wait_for(STAT_TXEMPTY, ANSWER_LIMIT_US);
    *kmi(KMI_DATA) = TIA_PS2_ENABLE;
    do
        answered = answered && wait_for(STAT_RXFULL, ANSWER_LIMIT_US);
    while (answered && *kmi(KMI_DATA) != TIA_PS2_ACKNOWLEDGE);
    if (answered)
        return TIA_OK;
    *kmi(KMI_CR) = 0;
    *(const char **)ctx = "keyboard: no answer (connect a PS/2 keyboard)";
    return TIA_ERR_DEVICE;
}

static int keyboard_poll(void *ctx, struct tia_event *event)
{
    (void)ctx;
    int found = tia_ps2_owed(&ps2, event);
    while (!found && *kmi(KMI_STAT) & STAT_RXFULL)
        found = tia_ps2_feed(&ps2, (uint8_t)*kmi(KMI_DATA), event) || tia_ps2_owed(&ps2, event);
    if (found)
        event->time_us = board_clock.now_us(NULL);
    return found;
}

static int keyboard_wait(void *ctx, int timeout_ms)
{
    (void)ctx;
    (void)wait_for(STAT_RXFULL, timeout_ms < 0 ? -1 : (int64_t)timeout_ms * 1000);
    return TIA_OK;
}

static void keyboard_close(void *ctx)
{
    (void)ctx;
    *kmi(KMI_CR) = 0;
}

const struct tia_input panel_keyboard = {keyboard_open, keyboard_poll, keyboard_wait, keyboard_close};
