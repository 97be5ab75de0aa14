/* shown.c - runs an example for a display, EXAMPLE, with the headers beside this file, and prints the library's version
 * and the CRC-32 of what the panel shows, as client.c does. */
#include <stdio.h>
#include <tia/debug.h>

#include EXAMPLE

int main(void)
{
    static tia_rgb565 pixels[PANEL_WIDTH * PANEL_HEIGHT];

#ifdef ESP_LCD_PANEL_OPS_H
    if (draw_spheres(NULL))
        return 1;
    panel_finish();
#else
    setup();
    loop();
#endif
    for (unsigned i = 0; i < PANEL_WIDTH * PANEL_HEIGHT; i++)
        pixels[i] = (tia_rgb565)(panel_bytes[2 * i] << 8 | panel_bytes[2 * i + 1]);
    printf("%s %08x\n", TIA_VERSION, (unsigned)tia_crc32(0, pixels, PANEL_WIDTH * PANEL_HEIGHT));
    return 0;
}
