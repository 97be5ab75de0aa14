#include "pack_write.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define ALIGNMENT 64

void pack_init(struct pack *pack)
{
    memset(pack, 0, sizeof *pack);
    for (unsigned i = 0; i < MODEL_ARRAYS; i++)
        pack->arrays[i].element = model_element((enum model_array_name)i);
}

void *pack_grow(struct pack_array *array, uint64_t count)
{
    uint64_t need = array->count + count;

    if (need > UINT32_MAX)
        return NULL;
    if (need > array->room || !array->items) {
        uint64_t room = array->room * 2 > need ? array->room * 2 : need + 16;
        char *items = room <= SIZE_MAX / array->element ? realloc(array->items, (size_t)room * array->element) : NULL;
        if (!items)
            return NULL;
        array->items = items;
        array->room = room;
    }
    void *first = array->items + array->count * array->element;
    memset(first, 0, (size_t)count * array->element);
    array->count = need;
    return first;
}

bool pack_add(struct pack_array *array, const void *element)
{
    void *to = pack_grow(array, 1);

    if (to)
        memcpy(to, element, array->element);
    return to;
}

static bool write_all(int fd, const char *from, size_t size, uint64_t offset)
{
    while (size > 0) {
        ssize_t done = pwrite(fd, from, size, (off_t)offset);
        if (done <= 0)
            return false;
        from += done;
        offset += (uint64_t)done;
        size -= (size_t)done;
    }
    return true;
}

bool pack_write(struct pack *pack, int fd)
{
    uint64_t at = sizeof pack->header;
    bool fits = true;

    for (unsigned i = 0; i < MODEL_ARRAYS; i++) {
        const struct pack_array *array = &pack->arrays[i];
        at = (at + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
        pack->header.offset[i] = at;
        pack->header.count[i] = array->count;
        fits = fits && write_all(fd, array->items, (size_t)array->count * array->element, at);
        at += array->count * array->element;
    }
    return fits && ftruncate(fd, (off_t)at) == 0 && write_all(fd, (const char *)&pack->header, sizeof pack->header, 0);
}
