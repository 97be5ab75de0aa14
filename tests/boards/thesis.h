/* The memory of thesis.tia, as tia-compile wrote it: do not edit. */
#ifndef THESIS_MEMORY
#define THESIS_MEMORY

#include <stdint.h>

/* Bytes on a machine with 64-bit pointers, with 32-bit ones, and with those and enumerations of a byte, as arm-none-eabi
 * has them. Where 64-bit numbers lie at multiples of 4, as on 32-bit x86, a little less is needed. */
#ifndef TIA_BYTES
enum tia_bytes_small { TIA_BYTES_SMALL };
typedef char tia_bytes_known[sizeof(void *) >= 4 ? 1 : -1]; /* fails on other machines: call tia_view_size there */
#define TIA_BYTES(wide, narrow, small) \
    (sizeof(void *) == 8 ? (wide) : sizeof(enum tia_bytes_small) > 1 ? (narrow) : (small))
#define TIA_WORDS(bytes) (((bytes) + 7) / 8) /* of an array of uint64_t, whose alignment is the right one */
#endif

/* A view with at most 1 lights; hits of a tile; all that tia_viewer_run asks for on a display of that size,
 * with an input and a clock. */
#define THESIS_VIEW TIA_BYTES(2096u, 2032u, 2032u)
#define THESIS_HITS_320x1 TIA_BYTES(2600u, 2584u, 2584u)
#define THESIS_VIEWER_320x1 TIA_BYTES(4720u, 4640u, 4640u)

/* Flash, about: the library's part of a program on a Cortex-M3 (gcc -Os), and the scene's tables. */
#define THESIS_FLASH_LIBRARY 48600u
#define THESIS_FLASH_SCENE 936u

#endif
