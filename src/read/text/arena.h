/* arena.h - how a reader puts its arrays into the caller's memory, without heap.
 *
 * A reader runs the same code over the text several times. In the first passes its arrays have no place:
 * what is added is only counted. Then they are placed in the arena, one after the other, exactly as large
 * as they were counted, and a last pass fills them:
 *
 *     read everything                     tia_array_add counts; syntax errors end it here
 *     tia_array_place(arena, &array)...   the arrays' addresses are known from now on
 *     if (!tia_arena_fits(arena))
 *         return TIA_OK;                  tia_read makes TIA_ERR_MEMORY of it, and *need
 *     read everything again               tia_array_add fills
 *
 * So the need is known after passes that store nothing, a reader has no limits of its own, and the
 * memory is exactly what the arrays take. What must be known earlier (names) is placed earlier.
 */
#ifndef TIA_SRC_READ_ARENA_H
#define TIA_SRC_READ_ARENA_H

#include <tia/read.h>

struct tia_arena {
    unsigned char *memory; /* aligned for uint64_t */
    size_t size, used;     /* used > size: it did not fit */
};

/* Room for `count` items of `item` bytes, aligned for uint64_t; NULL when there is none left or the count
 * is 0. What did not fit is counted in `used` all the same. */
void *tia_arena_take(struct tia_arena *arena, size_t count, size_t item);

bool tia_arena_fits(const struct tia_arena *arena);

struct tia_array {
    size_t item;    /* bytes of one; the array starts as {sizeof(struct thing)} */
    uint32_t count; /* the index of what is added next */
    uint32_t capacity;
    unsigned char *items; /* NULL as long as it is only counted */
};

/* Copies *item behind the array's last one, as far as there is room, and counts it. */
void tia_array_add(struct tia_array *array, const void *item);

/* Forgets what was counted, for another pass. */
void tia_array_restart(struct tia_array *array);

/* Takes as much room as was counted, and restarts. Returns the array's place. */
void *tia_array_place(struct tia_arena *arena, struct tia_array *array);

#endif
