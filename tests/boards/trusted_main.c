/* trusted_main.c - runs the example of docs/trust.md: right frames, a frame with a wrong pixel, and a changed view. */
#include <stdio.h>

#include "trusted.c"

static bool breaks;

static void send(struct tia_tile tile, tia_rgb565 *pixels)
{
    if (breaks && tile.y == 120)
        pixels[160] ^= 1;
}

int main(void)
{
    printf("prepare %d\n", prepare());
    for (uint32_t state = 0; state < 5; state++)
        printf("state %u: %d\n", (unsigned)state, draw(state, send));
    breaks = true;
    printf("a wrong pixel: %d\n", draw(1, send));
    breaks = false;
    printf("a right frame: %d\n", draw(1, send));
    view_memory[30] ^= 4;
    printf("a changed view: %d\n", draw(1, send));
    printf("prepare %d\n", prepare());
    printf("a right frame: %d\n", draw(2, send));
    return 0;
}
