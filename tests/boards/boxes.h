/* boxes.h - the scene of light.c and shadows.c, two boxes, one of them turned, and a triangle on a plane; and their
 * reports. */
#ifndef TESTS_BOARDS_BOXES_H
#define TESTS_BOARDS_BOXES_H

#include <tia/tia.h>

#define Q(x) ((tia_q16)((x)*65536))
#define ONE (INT32_C(1) << 30)

static const struct tia_transform turned = {{Q(1.8), Q(0.7), Q(1.3)}, {Q(10), Q(30), 0}, {Q(1), Q(1), Q(1)}};
static const struct tia_shape shapes[] = {
    {TIA_PLANE, .plane = {{0, 0, 0}, {0, ONE, 0}}},
    {TIA_BOX, 1, .box = {{Q(-1), Q(0.25), Q(-1)}, {Q(1), Q(1.25), Q(1)}}},
    {TIA_BOX, 1, 1, .box = {{Q(-0.3), Q(-0.7), Q(-0.3)}, {Q(0.3), Q(0.7), Q(0.3)}}},
    {TIA_TRIANGLE, .triangle = {{{Q(-3), Q(0.2), 0}, {Q(-1.5), Q(0.2), Q(1.5)}, {Q(-2), Q(2.5), Q(0.5)}}}},
};

/* Prints a line: a picture's name and checksum, and the sizes in bytes of the view and of a tile's hits. */
#if __STDC_HOSTED__
#include <stdio.h>
static void tell(const char *name, uint32_t crc, size_t view, size_t hits)
{
    printf("%s %08lx %lu %lu\n", name, (unsigned long)crc, (unsigned long)view, (unsigned long)hits);
}
#else
#include "boards/board.h"
static void tell(const char *name, uint32_t crc, size_t view, size_t hits)
{
    board_print(name);
    board_print(" ");
    board_print_hex(crc);
    board_print(" ");
    board_print_number((uint32_t)view);
    board_print(" ");
    board_print_number((uint32_t)hits);
    board_print("\n");
}
#endif

#endif
