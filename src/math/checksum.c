#include "fast.h"

#include "checksum.h"

/* Number of words after which the sums are reduced: from below 2^32 they grow to 2^47 and 2^62. */
#define WORDS 32768

/* A word of memory that holds any type. */
#ifdef __GNUC__
typedef uint32_t __attribute__((__may_alias__)) any_word;
#define HAS_ANY_WORD 1
#else
typedef uint32_t any_word;
#define HAS_ANY_WORD 0
#endif

static uint64_t reduced(uint64_t sum)
{
    sum = (sum & UINT32_MAX) + (sum >> 32);
    return (sum & UINT32_MAX) + (sum >> 32);
}

static void reduce(struct checksum *sum)
{
    sum->first = reduced(sum->first);
    sum->second = reduced(sum->second);
}

static void add_words(struct checksum *sum, const any_word *words, size_t count)
{
    uint64_t first = sum->first, second = sum->second;
    const any_word *end = words + count / 4 * 4;

    for (; words < end; words += 4) {
        first += words[0];
        second += first;
        first += words[1];
        second += first;
        first += words[2];
        second += first;
        first += words[3];
        second += first;
    }
    for (end += count % 4; words < end; words++) {
        first += *words;
        second += first;
    }
    sum->first = first;
    sum->second = second;
}

/* Adds up to four bytes as one word, in little-endian order. */
static void add_bytes(struct checksum *sum, const uint8_t *bytes, size_t count)
{
    uint32_t word = 0;

    for (size_t i = 0; i < count; i++)
        word |= (uint32_t)bytes[i] << 8 * i;
    sum->first += word;
    sum->second += sum->first;
}

/* Adds at most WORDS words, in the memory's own order if it is aligned. */
static void add_block(struct checksum *sum, const uint8_t *bytes, size_t size)
{
    size_t at = 0;

    if (HAS_ANY_WORD && (uintptr_t)bytes % sizeof(any_word) == 0) {
        at = size / 4 * 4;
        add_words(sum, (const any_word *)(const void *)bytes, size / 4);
    }
    for (; at < size; at += 4)
        add_bytes(sum, bytes + at, size - at < 4 ? size - at : 4);
    reduce(sum);
}

void tia_checksum_add(struct checksum *sum, const void *memory, size_t size)
{
    const uint8_t *bytes = memory;
    size_t block;

    for (; size; size -= block, bytes += block) {
        block = size / 4 < WORDS ? size : WORDS * (size_t)4;
        add_block(sum, bytes, block);
    }
}

uint64_t tia_checksum_value(const struct checksum *sum)
{
    return sum->second << 32 | sum->first;
}
