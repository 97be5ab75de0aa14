/* panel.h - a panel of 320x240 in memory, whose pixels arrive high byte first. */
#ifndef PANEL_H
#define PANEL_H

#include <stdint.h>
#include <string.h>

#define PANEL_WIDTH 320
#define PANEL_HEIGHT 240

static uint8_t panel_bytes[2 * PANEL_WIDTH * PANEL_HEIGHT];

/* Takes pixels that are in the processor's byte order if `swap`, else as they are. */
static inline void panel_take(int32_t x, int32_t y, int32_t w, int32_t h, const uint16_t *data, int swap)
{
    if (x < 0 || y < 0 || x + w > PANEL_WIDTH || y + h > PANEL_HEIGHT)
        return;
    for (int32_t i = 0; i < w * h; i++) {
        uint8_t *to = panel_bytes + 2 * ((y + i / w) * PANEL_WIDTH + x + i % w);
        if (swap) {
            to[0] = (uint8_t)(data[i] >> 8);
            to[1] = (uint8_t)data[i];
        } else {
            memcpy(to, data + i, 2);
        }
    }
}

#endif
