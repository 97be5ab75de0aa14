/* pl11x.c - the PL110 and PL111 panel controllers. Registers: Arm DDI 0161 and DDI 0293; the Versatile's PL110 has its
 * LCDControl at the PL111's address. */
#include "panel_board.h"

enum {
    LCD_TIMING0 = 0x00,
    LCD_TIMING1 = 0x04,
    LCD_TIMING2 = 0x08,
    LCD_UPBASE = 0x10,
    LCD_CONTROL = 0x18,
    LCD_RIS = 0x20,
    LCD_ICR = 0x28,
    NEXT_BASE = 1 << 2, /* in RIS and ICR: the controller has read UPBASE */
    ENABLE = 1 << 0,
    TFT = 1 << 5,
    POWER = 1 << 11,
    POWER_DELAY_US = 20000, /* least time from ENABLE to POWER: DDI 0161, 3.4 */
    SYNC_LIMIT_US = 10000000
};

static uint16_t frames[2][PANEL_WIDTH * PANEL_HEIGHT] __attribute__((aligned(8)));
static unsigned drawn; /* index of the back buffer */

static volatile uint32_t *lcd(uintptr_t offset)
{
    return panel_board_register(panel_board.panel, offset);
}

static void wait_us(uint64_t us)
{
    uint64_t start = board_clock.now_us(NULL);
    while (board_clock.now_us(NULL) - start < us) {
    }
}

static int panel_mode(void *ctx, struct tia_mode *mode)
{
    (void)ctx;
    *mode = (struct tia_mode){.width = PANEL_WIDTH, .height = PANEL_HEIGHT, .format = "RGB565"};
    return TIA_OK;
}

/* Opens the panel with the timing of VGA's 640x480 at 60 Hz: front porch, sync and back porch are 16, 96 and 48 pixels,
 * and 10, 2 and 33 lines. The pixel clock is the 25 MHz that the board has at power-on. */
static int panel_open(void *ctx, struct tia_mode *mode)
{
    panel_board.prepare_panel();
    *lcd(LCD_TIMING0) = (PANEL_WIDTH / 16 - 1) << 2 | (96 - 1) << 8 | (16 - 1) << 16 | (48 - 1) << 24;
    *lcd(LCD_TIMING1) = (PANEL_HEIGHT - 1) | (2 - 1) << 10 | 10 << 16 | 33u << 24;
    *lcd(LCD_TIMING2) = 1 << 11 | 1 << 12 | (PANEL_WIDTH - 1) << 16 | 1 << 26; /* both syncs low, no divider */
    *lcd(LCD_UPBASE) = (uint32_t)(uintptr_t)frames[0];
    drawn = 1;
    *lcd(LCD_CONTROL) = panel_board.panel_format | TFT | ENABLE;
    wait_us(POWER_DELAY_US);
    *lcd(LCD_CONTROL) |= POWER;
    return panel_mode(ctx, mode);
}

static int panel_acquire(void *ctx, struct tia_tile tile, struct tia_surface *surface)
{
    (void)ctx;
    *surface = (struct tia_surface){
        .pixels = &frames[drawn][tile.y * PANEL_WIDTH + tile.x], .step = 2, .pitch = 2 * PANEL_WIDTH};
    return TIA_OK;
}

static int panel_submit(void *ctx, struct tia_tile tile)
{
    (void)ctx, (void)tile;
    return TIA_OK;
}

/* Sets the new address and waits until the controller switches to it at the start of its next frame: until then the
 * controller reads the old buffer. */
static int panel_present(void *ctx)
{
    uint64_t start = board_clock.now_us(NULL);
    *lcd(LCD_ICR) = NEXT_BASE;
    *lcd(LCD_UPBASE) = (uint32_t)(uintptr_t)frames[drawn];
    while (!(*lcd(LCD_RIS) & NEXT_BASE))
        if (board_clock.now_us(NULL) - start > SYNC_LIMIT_US) {
            *(const char **)ctx = "panel: no vertical sync (is the pixel clock on?)";
            return TIA_ERR_DEVICE;
        }
    drawn ^= 1;
    return TIA_OK;
}

/* Switches off in the reverse order of open: power first, then the signals. */
static void panel_close(void *ctx)
{
    (void)ctx;
    if (!(*lcd(LCD_CONTROL) & ENABLE))
        return;
    *lcd(LCD_CONTROL) &= ~(uint32_t)POWER;
    wait_us(POWER_DELAY_US);
    *lcd(LCD_CONTROL) = 0;
}

const struct tia_display panel_display = {panel_open,    panel_mode,  panel_acquire, panel_submit,
                                          panel_present, panel_close, NULL};
