/* The checksum of memory, against its definition in 128 bits, and what it notices. */
#include "check.h"
#include "math/checksum.h"

__extension__ typedef unsigned __int128 wide128;

enum { LONG = 100000 }; /* words: sums are reduced several times */

static uint32_t words[LONG];

static uint64_t sum_of(const void *memory, size_t size)
{
    struct checksum sum = {0, 0};

    tia_checksum_add(&sum, memory, size);
    return tia_checksum_value(&sum);
}

/* sum(w_i) and sum((n + 1 - i) w_i) modulo 2^32 - 1. */
static uint64_t defined(const uint32_t *w, size_t n)
{
    wide128 first = 0, second = 0;

    for (size_t i = 0; i < n; i++) {
        first += w[i];
        second += (wide128)(n - i) * w[i];
    }
    return (uint64_t)(second % UINT32_MAX) << 32 | (uint64_t)(first % UINT32_MAX);
}

/* 2^32 - 1 is another form of 0. */
static uint64_t lowest(uint64_t value)
{
    return (value >> 32) % UINT32_MAX << 32 | (value & UINT32_MAX) % UINT32_MAX;
}

TEST(sums_as_defined)
{
    static const size_t counts[] = {0, 1, 2, 3, 4, 5, 7, 8, 1023, 32767, 32768, 32769, 65536, LONG};

    for (unsigned pattern = 0; pattern < 3; pattern++) {
        for (size_t i = 0; i < LONG; i++)
            words[i] = pattern == 0 ? UINT32_MAX - 1 : pattern == 1 ? (uint32_t)(i * 2654435761u) : UINT32_MAX;
        for (size_t i = 0; i < sizeof counts / sizeof *counts; i++)
            CHECK(lowest(sum_of(words, 4 * counts[i])) == defined(words, counts[i]));
    }
}

TEST(bytes_that_are_no_words)
{
    uint8_t bytes[40] = {0};

    for (size_t size = 0; size < 32; size++)
        for (size_t start = 0; start < 5; start++) {
            uint64_t before = sum_of(bytes + start, size);
            for (size_t i = 0; i < size; i++) {
                bytes[start + i] ^= 0x40;
                CHECK_MSG(sum_of(bytes + start, size) != before, "byte %zu of %zu from %zu", i, size, start);
                bytes[start + i] ^= 0x40;
            }
            bytes[start + size] ^= 1;
            CHECK_MSG(sum_of(bytes + start, size) == before, "the byte behind %zu from %zu", size, start);
            bytes[start + size] ^= 1;
        }
}

TEST(parts_in_order)
{
    struct checksum sum = {0, 0};

    for (size_t i = 0; i < LONG; i++)
        words[i] = (uint32_t)(i * 40503u) << 7;
    for (size_t i = 0; i < 1000; i += 8)
        tia_checksum_add(&sum, words + i, 32);
    CHECK(tia_checksum_value(&sum) == sum_of(words, 4000));
}

/* Each one and two of the bits of 8 words, of numbers, zeros and ones. */
TEST(one_and_two_changed_bits)
{
    for (unsigned pattern = 0; pattern < 3; pattern++) {
        uint32_t w[8];
        for (unsigned i = 0; i < 8; i++)
            w[i] = pattern == 0 ? 0 : pattern == 1 ? UINT32_MAX : (i + 1) * 2654435761u;
        uint64_t before = lowest(sum_of(w, sizeof w));
        for (unsigned a = 0; a < 256; a++) {
            w[a / 32] ^= UINT32_C(1) << a % 32;
            CHECK_MSG(lowest(sum_of(w, sizeof w)) != before, "bit %u", a);
            for (unsigned b = 0; b < a; b++) {
                w[b / 32] ^= UINT32_C(1) << b % 32;
                CHECK_MSG(lowest(sum_of(w, sizeof w)) != before, "bits %u and %u", a, b);
                w[b / 32] ^= UINT32_C(1) << b % 32;
            }
            w[a / 32] ^= UINT32_C(1) << a % 32;
        }
    }
}

int main(void)
{
    RUN(sums_as_defined);
    RUN(bytes_that_are_no_words);
    RUN(parts_in_order);
    RUN(one_and_two_changed_bits);
    return check_status();
}
