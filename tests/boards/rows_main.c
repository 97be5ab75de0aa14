/* rows_main.c - runs the short example of docs/boards.md, word for word, on a board, and prints the checksum of the
 * picture that it sends and the stack that it takes. */
#include "boards/board.h"
#include <tia/debug.h>

int draw(int (*send_row)(void *panel, unsigned y, const tia_rgb565 *pixels, unsigned width), void *panel);

#include "rows.c"

static int sum_row(void *ctx, unsigned y, const tia_rgb565 *pixels, unsigned width)
{
    uint32_t *crc = ctx;

    (void)y;
    *crc = tia_crc32(*crc, pixels, width);
    return TIA_OK;
}

int main(void)
{
    uint32_t crc = 0;
    int status = draw(sum_row, &crc);

    board_print_hex(crc);
    board_print("\nstack ");
    board_print_number(board_stack_used());
    board_print("\n");
    return status ? 1 : 0;
}
