/* The memory of thesis.tia, as tia-compile wrote it: do not edit. */
#ifndef THESIS_MEMORY
#define THESIS_MEMORY

#include <stdint.h>

/* Bytes on a machine with 64-bit pointers, with 32-bit ones, and with those and enumerations of a byte, as arm-none-eabi
 * has them. Where 64-bit numbers lie at multiples of 4, as on 32-bit x86, and on an AVR, a little less is needed. */
#ifndef TIA_BYTES
enum tia_bytes_small { TIA_BYTES_SMALL };
typedef char tia_bytes_known[sizeof(void *) <= 8 ? 1 : -1]; /* fails on other machines: call tia_view_size there */
#define TIA_BYTES(wide, narrow, small) \
    (sizeof(void *) == 8 ? (wide) : sizeof(enum tia_bytes_small) > 1 ? (narrow) : (small))
#define TIA_WORDS(bytes) (((bytes) + 7) / 8) /* of an array of uint64_t, whose alignment is the right one */
#endif

/* A view with at most 1 lights; hits of a tile; all that tia_viewer_run asks for on a display of that size,
 * with an input and a clock. */
#define THESIS_VIEW TIA_BYTES(2352u, 2288u, 2288u)
#define THESIS_HITS_320x1 TIA_BYTES(2600u, 2584u, 2584u)
#define THESIS_VIEWER_320x1 TIA_BYTES(4968u, 4888u, 4888u)
#define THESIS_HITS_64x1 TIA_BYTES(552u, 536u, 536u)
#define THESIS_VIEWER_64x1 TIA_BYTES(2920u, 2840u, 2840u)

/* tia_draw_rows, with rows of so many pixels; if fewer are drawn at once, the hits are those of a tile of one
 * row with so many: ROWS_320 - HITS_320x1 + HITS_64x1. */
#define THESIS_ROWS_320 TIA_BYTES(5592u, 5512u, 5512u)
#define THESIS_ROWS_64 TIA_BYTES(3032u, 2952u, 2952u)

/* Stack, at most: of the library's functions that draw, on processors of 32 bits (gcc -Os); smaller with the library
 * compiled with TIA_CHUNK=32 or 16, and then with TIA_BALL_WORDS=8. */
#define THESIS_STACK 6848u
#define THESIS_STACK_32 5376u
#define THESIS_STACK_16 5120u
#define THESIS_STACK_16_8 3968u

/* Flash, about: the library's part of a program on a Cortex-M3 (gcc -Os), and the scene's tables. */
#define THESIS_FLASH_LIBRARY 48600u
#define THESIS_FLASH_SCENE 968u

#endif
