/* print.c - prints numbers. */
#include "board.h"

void board_print_number(uint32_t value)
{
    char text[11], *digit = text + sizeof text - 1;
    *digit = 0;
    do {
        *--digit = (char)('0' + value % 10);
        value /= 10;
    } while (value);
    board_print(digit);
}

void board_print_hex(uint32_t value)
{
    char text[9] = {0};
    for (int i = 0; i < 8; i++)
        text[i] = "0123456789abcdef"[value >> (28 - 4 * i) & 15];
    board_print(text);
}
