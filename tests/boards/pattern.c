/* pattern.c - shows every RGB565 value on a board's panel, since the viewer's grey scene would not show exchanged red
 * and blue. Ends at a key. */
#include "boards/panel_board.h"

static int show(const char **why)
{
    struct tia_mode mode = {0};
    struct tia_surface surface;
    int status = panel_display.open(why, &mode);
    const struct tia_tile all = {0, 0, mode.width, mode.height};
    if (!status)
        status = panel_display.acquire(why, all, &surface);
    for (uint32_t i = 0; !status && i < (uint32_t)PANEL_WIDTH * PANEL_HEIGHT; i++)
        surface.pixels[i] = (tia_rgb565)i;
    if (!status)
        status = panel_display.submit(why, all);
    if (!status)
        status = panel_display.present(why);
    return status;
}

int main(void)
{
    const char *why = "";
    struct tia_event event;
    int status = panel_keyboard.open(&why);
    if (!status)
        status = show(&why);
    board_print(!status ? "ready\n" : why);
    while (!status && panel_keyboard.poll(&why, &event) == 0)
        (void)panel_keyboard.wait(&why, -1);
    panel_display.close(&why);
    panel_keyboard.close(&why);
    return -status;
}
