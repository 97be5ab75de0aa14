// TFT_eSPI.h - in place of the library's header: the functions that the example calls, as the library's README and
// header declare them, on a panel in memory.
#ifndef TFT_ESPI_H
#define TFT_ESPI_H

#include "panel.h"

class TFT_eSPI
{
  public:
    void init(uint8_t colour = 0)
    {
        (void)colour;
        started = true;
    }
    void setRotation(uint8_t rotation) { landscape = rotation & 1; }
    void setSwapBytes(bool swap) { swapped = swap; }
    void pushImage(int32_t x, int32_t y, int32_t w, int32_t h, uint16_t *data)
    {
        pushImage(x, y, w, h, const_cast<const uint16_t *>(data));
    }
    void pushImage(int32_t x, int32_t y, int32_t w, int32_t h, const uint16_t *data)
    {
        if (started && landscape)
            panel_take(x, y, w, h, data, swapped);
    }

  private:
    bool started = false, landscape = false, swapped = false;
};

#endif
