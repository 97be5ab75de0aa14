#include "terminal/chafa/chafa_pixels.h"

#include <stdlib.h>

#include "terminal/terminal_colour.h"

uint8_t *expand(const tia_rgb565 *pixels, size_t count, unsigned times)
{
    uint8_t *rgba = malloc(count * times * 4), *to = rgba;

    for (size_t i = 0; rgba && i < count; i++) {
        struct rgb8 c = colour_expand(pixels[i]);
        for (unsigned j = 0; j < times; j++, to += 4) {
            to[0] = c.r;
            to[1] = c.g;
            to[2] = c.b;
            to[3] = 255;
        }
    }
    return rgba;
}
