/* model_bytes.h - models made of bytes: four triangles as binary .stl. */
#ifndef TESTS_MODEL_BYTES_H
#define TESTS_MODEL_BYTES_H

#include "reading.h"

struct bytes {
    unsigned char at[8192];
    size_t length;
    bool big;
};

static inline void put(struct bytes *b, const void *from, size_t size)
{
    const unsigned char *bytes = from;
    for (size_t i = 0; i < size; i++)
        b->at[b->length++] = bytes[b->big ? size - 1 - i : i];
}

static inline void put_string(struct bytes *b, const char *string)
{
    memcpy(b->at + b->length, string, strlen(string));
    b->length += strlen(string);
}

static inline void put_float(struct bytes *b, float x)
{
    put(b, &x, sizeof x);
}

static inline void put_u32(struct bytes *b, uint32_t x)
{
    put(b, &x, sizeof x);
}

static inline void read_bytes(struct reading *r, enum tia_format format, const struct bytes *b)
{
    *r = (struct reading){.reader = {.format = format, .text = (const char *)b->at, .length = b->length}};
    read_begin(r);
}

static const float corners[4][3] = {{0, 0, 0}, {2, 0, 0.5F}, {0, 1.25F, 0}, {0, 0, -3}};
static const unsigned char faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

static inline struct bytes binary_stl(void)
{
    struct bytes b = {.length = 80};

    put_u32(&b, 4);
    for (int i = 0; i < 4; i++) {
        for (int k = 0; k < 3; k++)
            put_float(&b, 9);
        for (int k = 0; k < 9; k++)
            put_float(&b, corners[faces[i][k / 3]][k % 3]);
        b.length += 2;
    }
    return b;
}

#endif
