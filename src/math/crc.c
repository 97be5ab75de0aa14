#include <tia/debug.h>
#include <tia/render.h>

/* The CRC of each 4-bit value, with the reflected polynomial. A table for 4 bits at a time takes 64 bytes; one for 8
 * bits would take 1 KiB. */
static const uint32_t table[16] = {
    0x00000000, 0x1db71064, 0x3b6e20c8, 0x26d930ac, 0x76dc4190, 0x6b6b51f4, 0x4db26158, 0x5005713c,
    0xedb88320, 0xf00f9344, 0xd6d6a3e8, 0xcb61b38c, 0x9b64c2b0, 0x86d3d2d4, 0xa00ae278, 0xbdbdf21c,
};

static uint32_t add_byte(uint32_t crc, uint32_t byte)
{
    crc ^= byte;
    crc = crc >> 4 ^ table[crc & 15];
    return crc >> 4 ^ table[crc & 15];
}

uint32_t tia_crc32(uint32_t crc, const tia_rgb565 *pixels, size_t count)
{
    if (!pixels)
        return crc;
    crc = ~crc;
    for (size_t i = 0; i < count; i++)
        crc = add_byte(add_byte(crc, pixels[i] & 255u), pixels[i] >> 8);
    return ~crc;
}
