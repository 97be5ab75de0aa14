/* spheres.c - a ball on the ground, ray-traced row by row for a panel of esp_lcd on an SPI bus, to copy into a project. The
 * task needs CONFIG_ESP_MAIN_TASK_STACK_SIZE=8192, or THESIS_STACK bytes and its own. */
#include <esp_lcd_panel_ops.h>
#include <tia/tia.h>

#include "thesis.h" /* tia-compile scenes/thesis.tia --name thesis --memory thesis.h -s 320x240 --lights 1 */

static uint64_t memory[TIA_WORDS(THESIS_ROWS_320)];
static _Alignas(4) uint16_t sent[2][320]; /* rows, high byte first: one is written while the other is sent */

static int send_row(void *panel, unsigned y, const tia_rgb565 *pixels, unsigned width)
{
    uint16_t *row = sent[y & 1]; /* esp_lcd has sent row y - 2, since it waits for a row before it begins the next */

    for (unsigned x = 0; x < width; x++)
        row[x] = (uint16_t)(pixels[x] << 8 | pixels[x] >> 8);
    return esp_lcd_panel_draw_bitmap(panel, 0, (int)y, (int)width, (int)y + 1, row) == ESP_OK ? TIA_OK : TIA_ERR_DEVICE;
}

int draw_spheres(esp_lcd_panel_handle_t panel)
{
    const struct tia_rows rows = {.core = &tia_core_spheres,
                                  .scene = &tia_thesis_scene,
                                  .lights = &tia_thesis_scene.bindings[0].state, /* key a's light */
                                  .light_count = 1,
                                  .width = 320,
                                  .height = 240};

    return tia_draw_rows(&rows, memory, sizeof memory, send_row, panel);
}
