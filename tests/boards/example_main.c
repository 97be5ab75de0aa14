/* example_main.c - runs the example of docs/boards.md, word for word, on the host or on a board, and prints the
 * checksum of the picture that it sends, on a board also the stack. Its instructions are between marks, those of this
 * file not. */
#include "marks.h"
#include <tia/debug.h>
#include <tia/tia.h>

int draw(void (*send_row)(unsigned y, const tia_rgb565 *pixels));

#include "example.c"

static uint32_t crc;
static unsigned rows;

static void sum_row(unsigned y, const tia_rgb565 *pixels)
{
    count_end();
    if (y == rows++)
        crc = tia_crc32(crc, pixels, 320);
    count_begin();
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
    board_print("\nstack ");
    board_print_number(board_stack_used());
    board_print("\n");
}
#endif

int main(void)
{
    count_begin();
    int status = draw(sum_row);
    count_end();
    tell(crc);
    return !status && rows == 240 ? 0 : 1;
}
