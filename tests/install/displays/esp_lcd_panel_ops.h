/* esp_lcd_panel_ops.h - in place of ESP-IDF's header: the function that the example calls, as its API reference
 * declares it. The panel reads a row only when the next one begins, as DMA may. */
#ifndef ESP_LCD_PANEL_OPS_H
#define ESP_LCD_PANEL_OPS_H

#include "panel.h"

typedef int esp_err_t;
#define ESP_OK 0
typedef struct esp_lcd_panel_t *esp_lcd_panel_handle_t;

static const uint16_t *panel_pending; /* a row that DMA has not read yet */

static inline void panel_finish(void)
{
    static int rows;
    if (panel_pending)
        panel_take(0, rows++, PANEL_WIDTH, 1, panel_pending, 0);
    panel_pending = 0;
}

static inline esp_err_t esp_lcd_panel_draw_bitmap(esp_lcd_panel_handle_t panel, int x_start, int y_start, int x_end,
                                                  int y_end, const void *color_data)
{
    (void)panel;
    panel_finish();
    if (x_start || x_end != PANEL_WIDTH || y_end != y_start + 1)
        return -1;
    panel_pending = (const uint16_t *)color_data;
    return ESP_OK;
}

#endif
