#include "checksum.h"

#include <tia/debug.h>
#include <tia/render.h>

/* tia_crc32 takes pixels of two bytes, low byte first, so an odd last byte is padded with a zero. The length comes
 * first, so that the padding differs from a zero in the data. */
uint32_t checksum_bytes(uint32_t crc, const void *bytes, size_t length)
{
    const unsigned char *from = bytes;
    uint64_t count = length;
    tia_rgb565 pairs[1024];
    for (unsigned i = 0; i < 4; i++)
        pairs[i] = (tia_rgb565)(count >> 16 * i & 0xffffu);
    crc = tia_crc32(crc, pairs, 4);
    while (length > 0) {
        size_t some = length < sizeof pairs ? length : sizeof pairs, n = (some + 1) / 2;
        for (size_t i = 0; i < n; i++) {
            unsigned high = 2 * i + 1 < some ? from[2 * i + 1] : 0;
            pairs[i] = (tia_rgb565)(from[2 * i] | high << 8);
        }
        crc = tia_crc32(crc, pairs, n);
        from += some;
        length -= some;
    }
    return crc;
}
