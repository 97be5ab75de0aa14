#include "typed.h"

#include <string.h>

/* Bytes stored until the keyboard is read; a process has one controlling terminal. */
static uint8_t kept[TYPED_MOST];
static size_t kept_count;

void typed_forget(void)
{
    kept_count = 0;
}

void typed_keep(const uint8_t *bytes, size_t count)
{
    size_t room = TYPED_MOST - kept_count, n = count < room ? count : room;

    memcpy(kept + kept_count, bytes, n);
    kept_count += n;
}

bool typed_any(void)
{
    return kept_count > 0;
}

size_t typed_take(uint8_t *bytes)
{
    size_t count = kept_count;

    memcpy(bytes, kept, count);
    kept_count = 0;
    return count;
}
