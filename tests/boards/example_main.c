/* example_main.c - runs the example of docs/boards.md, word for word, on the host or on a board, and
 * prints the checksum of the picture that it sends. */
#include <tia/debug.h>
#include <tia/tia.h>

int draw(void (*send_row)(unsigned y, const tia_rgb565 *pixels));

#include "example.c"

static uint32_t crc;
static unsigned rows;

static void sum_row(unsigned y, const tia_rgb565 *pixels)
{
    if (y == rows++)
        crc = tia_crc32(crc, pixels, 320);
}

#if __STDC_HOSTED__
#include <stdio.h>
static void tell(uint32_t value)
{
    printf("%08lx\n", (unsigned long)value);
}
#else
#include "boards/board.h"
static void tell(uint32_t value)
{
    board_print_hex(value);
    board_print("\n");
}
#endif

int main(void)
{
    int status = draw(sum_row);
    tell(crc);
    return !status && rows == 240 ? 0 : 1;
}
