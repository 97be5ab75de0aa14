/* stream_x86.h - stores of pixels past the caches, for SSE4.1, AVX2 and AVX-512. Stores of 16 bytes suffice, as the
 * processor combines them into whole cache lines. */
#ifndef TIA_SIMD_ISA_STREAM_X86_H
#define TIA_SIMD_ISA_STREAM_X86_H

#include <emmintrin.h>
#include <stdint.h>

#define LINE 64 /* bytes of a cache line; it holds half as many pixels */

static void stream_pixels(uint16_t *out, const uint16_t *from, int count)
{
    const uint16_t *end = from + count;

    for (; from < end && (uintptr_t)out % LINE; out++, from++)
        *out = *from;
    for (; end - from >= LINE / 2; out += LINE / 2, from += LINE / 2)
        for (int i = 0; i < LINE / 2; i += 8)
            _mm_stream_si128((void *)(out + i), _mm_loadu_si128((const void *)(from + i)));
    for (; from < end; out++, from++)
        *out = *from;
}

/* Orders the streamed pixels before later stores; otherwise they may become visible after these. */
static void settle_pixels(void)
{
    _mm_sfence();
}

#define STREAM stream_pixels, settle_pixels

#endif
