/* tia_crc32 against zlib's values, the check value of CRC catalogues and division bit by bit. */
#include <tia/debug.h>
#include <tia/render.h>

#include "check.h"

#define MOST 1024

static tia_rgb565 pixels[MOST];

/* Returns the CRC of pixels that have these little-endian bytes. */
static uint32_t crc_of(const void *bytes, size_t size)
{
    const uint8_t *b = bytes;

    for (size_t i = 0; i < size / 2; i++)
        pixels[i] = (tia_rgb565)(b[2 * i] | b[2 * i + 1] << 8);
    return tia_crc32(0, pixels, size / 2);
}

/* Divides by definition: the remainder modulo the reflected polynomial 0xedb88320 (IEEE 802.3), begun with ones and
 * inverted at the end. */
static uint32_t divide(const uint8_t *bytes, size_t size)
{
    uint32_t rest = UINT32_MAX;

    for (size_t i = 0; i < size; i++) {
        rest ^= bytes[i];
        for (int bit = 0; bit < 8; bit++)
            rest = rest >> 1 ^ (rest & 1 ? UINT32_C(0xedb88320) : 0);
    }
    return ~rest;
}

/* Expected values of python3 -c 'import zlib; print(hex(zlib.crc32(b"1234567890")))' and so on. */
TEST(values_of_zlib)
{
    uint8_t bytes[32];

    CHECK_EQ(crc_of("12345678", 8), 0x9ae0daaf);
    CHECK_EQ(crc_of("1234567890", 10), 0x261daee5);
    memset(bytes, 0, sizeof bytes);
    CHECK_EQ(crc_of(bytes, sizeof bytes), 0x190a55ad);
    memset(bytes, 0xff, sizeof bytes);
    CHECK_EQ(crc_of(bytes, sizeof bytes), 0xff6cab0b);
    for (size_t i = 0; i < sizeof bytes; i++)
        bytes[i] = (uint8_t)i;
    CHECK_EQ(crc_of(bytes, sizeof bytes), 0x91267e8a);
}

TEST(division_bit_by_bit)
{
    uint8_t bytes[2 * MOST];

    CHECK_EQ(divide((const uint8_t *)"123456789", 9), 0xcbf43926); /* the catalogues' check value */
    for (size_t i = 0; i < sizeof bytes; i++)
        bytes[i] = (uint8_t)(i * i % 251 + i / 7);
    for (size_t size = 0; size <= sizeof bytes; size += 2)
        CHECK_EQ(crc_of(bytes, size), divide(bytes, size));
    for (unsigned value = 0; value < 65536; value++) {
        uint8_t two[2] = {(uint8_t)value, (uint8_t)(value >> 8)};
        CHECK_EQ(crc_of(two, 2), divide(two, 2));
    }
}

TEST(nothing_changes_nothing)
{
    CHECK_EQ(tia_crc32(0, NULL, 0), 0);
    CHECK_EQ(tia_crc32(0x12345678, NULL, 0), 0x12345678);
}

TEST(in_parts)
{
    uint32_t whole;

    for (size_t i = 0; i < MOST; i++)
        pixels[i] = (tia_rgb565)(i * 40503);
    whole = tia_crc32(0, pixels, MOST);
    for (size_t cut = 0; cut <= MOST; cut++)
        CHECK_EQ(tia_crc32(tia_crc32(0, pixels, cut), pixels + cut, MOST - cut), whole);
}

int main(void)
{
    RUN(values_of_zlib);
    RUN(division_bit_by_bit);
    RUN(nothing_changes_nothing);
    RUN(in_parts);
    return check_status();
}
