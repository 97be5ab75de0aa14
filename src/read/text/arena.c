/* arena.c - arrays that are first counted and then filled. */
#include "arena.h"

#define ALIGNMENT sizeof(uint64_t)

void *tia_arena_take(struct tia_arena *arena, uint32_t count, size_t item)
{
    size_t start = arena->used;

    if (!count)
        return NULL;
    if (count > (SIZE_MAX - start - ALIGNMENT) / item) {
        arena->used = SIZE_MAX - ALIGNMENT;
        return NULL;
    }
    arena->used = start + ((size_t)count * item + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
    return tia_arena_fits(arena) ? arena->memory + start : NULL;
}

bool tia_arena_fits(const struct tia_arena *arena)
{
    return arena->used <= arena->size;
}

void tia_array_add(struct tia_array *array, const void *item)
{
    const unsigned char *from = item;

    if (array->items && array->count < array->capacity) {
        unsigned char *to = array->items + array->count * array->item;
        for (size_t i = 0; i < array->item; i++)
            to[i] = from[i];
    }
    array->count += array->count < UINT32_MAX;
}

void tia_array_restart(struct tia_array *array)
{
    array->count = 0;
}

void *tia_array_place(struct tia_arena *arena, struct tia_array *array)
{
    array->capacity = array->count;
    array->items = tia_arena_take(arena, array->count, array->item);
    array->count = 0;
    return array->items;
}
