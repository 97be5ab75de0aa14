#include "palette.h"

#include <math.h>

static unsigned level(double x, double most)
{
    return (unsigned)(fmin(fmax(x, 0), 1) * most + 0.5);
}

tia_rgb565 palette_rgb(double r, double g, double b)
{
    return (tia_rgb565)(level(r, 31) << 11 | level(g, 63) << 5 | level(b, 31));
}

tia_rgb565 palette_heat(double t)
{
    static const double stops[5][3] = {{0, 0, 0}, {0.1, 0.1, 0.8}, {0.9, 0.1, 0.2}, {1, 0.9, 0.1}, {1, 1, 1}};
    double at = fmin(fmax(t, 0), 1) * 4;
    int i = at < 3 ? (int)at : 3;
    double part = at - i, rgb[3];

    for (int c = 0; c < 3; c++)
        rgb[c] = stops[i][c] + part * (stops[i + 1][c] - stops[i][c]);
    return palette_rgb(rgb[0], rgb[1], rgb[2]);
}

/* Returns a colour. The hues of successive numbers are a golden section of the colour circle apart. */
tia_rgb565 palette_number(uint32_t n)
{
    double hue = fmod((double)n * 0.6180339887498949, 1) * 6, rgb[3];

    for (int c = 0; c < 3; c++) {
        double from = fmod(hue + 6 - 2.0 * c, 6);
        rgb[c] = 0.2 + 0.8 * fmin(fmax(fmax(2 - from, from - 4), 0), 1);
    }
    return palette_rgb(rgb[0], rgb[1], rgb[2]);
}
