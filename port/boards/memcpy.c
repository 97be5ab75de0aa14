/* memcpy.c - memcpy and memset, which compilers call even where the source does not. */
#include <stddef.h>
#include <stdint.h>

/* A word type that may alias objects of any type. */
typedef uint32_t __attribute__((may_alias)) word;

void *memcpy(void *restrict to, const void *restrict from, size_t count);
void *memset(void *to, int value, size_t count);

/* Keeps gcc from replacing the loops below by calls of memcpy and memset: each function would call itself. */
#define AS_WRITTEN __attribute__((optimize("no-tree-loop-distribute-patterns")))

/* Copies words if both addresses are aligned; copies all else, which is short or rare, byte by byte. */
AS_WRITTEN void *memcpy(void *restrict to, const void *restrict from, size_t count)
{
    unsigned char *bytes = to;
    const unsigned char *source = from;
    if (((uintptr_t)to | (uintptr_t)from) % 4 == 0)
        for (; count >= 4; count -= 4, bytes += 4, source += 4)
            *(word *)bytes = *(const word *)source;
    while (count--)
        *bytes++ = *source++;
    return to;
}

AS_WRITTEN void *memset(void *to, int value, size_t count)
{
    unsigned char *bytes = to, byte = (unsigned char)value;
    for (; count && (uintptr_t)bytes % 4; count--)
        *bytes++ = byte;
    for (; count >= 16; count -= 16, bytes += 16) {
        word *words = (word *)bytes;
        words[0] = words[1] = words[2] = words[3] = byte * 0x01010101u;
    }
    while (count--)
        *bytes++ = byte;
    return to;
}
