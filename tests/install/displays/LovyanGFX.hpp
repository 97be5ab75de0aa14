// LovyanGFX.hpp - in place of the library's header: the functions that the example calls, as LGFXBase.hpp declares them, on a
// panel in memory.
#ifndef LOVYANGFX_HPP
#define LOVYANGFX_HPP

#include "panel.h"

#ifdef LGFX_AUTODETECT
class LGFX
{
  public:
    bool init()
    {
        return started = true;
    }
    void setRotation(uint_fast8_t rotation)
    {
        landscape = rotation & 1;
    }
    void setSwapBytes(bool swap)
    {
        swapped = swap;
    }
    template <typename T> void pushImage(int32_t x, int32_t y, int32_t w, int32_t h, const T *data)
    {
        if (started && landscape)
            panel_take(x, y, w, h, data, swapped);
    }

  private:
    bool started = false, landscape = false, swapped = false;
};
#endif

#endif
