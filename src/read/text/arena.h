/* arena.h - a reader's arrays in the caller's memory, without heap.
 *
 * A reader runs the same code over the text several times. In the first passes arrays have no memory, and adding an
 * item only counts it. Then the arrays are placed in the arena, one after the other, and a last pass fills them:
 *
 *     read everything                     tia_array_add counts; syntax errors are found here
 *     tia_array_place(arena, &array)...   the arrays' addresses are known from now on
 *     if (!tia_arena_fits(arena))
 *         return TIA_OK;                  tia_read turns this into TIA_ERR_MEMORY and *need
 *     read everything again               tia_array_add stores
 *
 * So the first passes compute the exact size of memory without storing anything, arrays never have to grow, and readers
 * have no limits of their own. An array that later passes use (names) is placed and filled earlier.
 */
#ifndef TIA_READ_TEXT_ARENA_H
#define TIA_READ_TEXT_ARENA_H

#include <tia/read.h>

struct tia_arena {
    unsigned char *memory; /* aligned for uint64_t */
    size_t size, used;     /* bytes; used > size: the memory is too small */
};

/* Allocates `count` items of `item` bytes, aligned for uint64_t. Returns NULL if they do not fit or the count is 0;
 * `used` grows even if they do not fit. */
void *tia_arena_take(struct tia_arena *arena, uint32_t count, size_t item);

bool tia_arena_fits(const struct tia_arena *arena);

struct tia_array {
    size_t item;    /* bytes of one item; initialise the array with {sizeof(struct thing)} */
    uint32_t count; /* also the index of the next item */
    uint32_t capacity;
    unsigned char *items; /* NULL in passes that only count */
};

/* Appends a copy of *item if the array has space left. Counts it in any case. */
void tia_array_add(struct tia_array *array, const void *item);

/* Sets the count to 0, for another pass. */
void tia_array_restart(struct tia_array *array);

/* Allocates memory for the items counted, then sets the count to 0. Returns the array's address. */
void *tia_array_place(struct tia_arena *arena, struct tia_array *array);

#endif
