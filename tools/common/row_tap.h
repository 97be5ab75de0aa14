/* row_tap.h - receives the rows of a picture or film while it is drawn, and chooses which rows are drawn: for records
 * and for tia-verify. */
#ifndef TOOLS_COMMON_ROW_TAP_H
#define TOOLS_COMMON_ROW_TAP_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct row_tap {
    /* True if row `y` of the file is to be drawn; any thread may call it. NULL: all rows are drawn. */
    bool (*wants)(void *ctx, uint32_t frame, unsigned y);
    /* Receives a row, in any order, one at a time: RGB565 as bytes, low byte first, or the bytes of image_rows, or a
     * row of sums with its checksum. */
    void (*row)(void *ctx, uint32_t frame, unsigned y, const unsigned char *bytes, size_t length);
    void *ctx;
    uint32_t *samples; /* NULL, or receives the number of samples a pixel of a picture of samples; 0: not as the options
                          say */
};

static inline bool tap_wants(const struct row_tap *tap, uint32_t frame, unsigned y)
{
    return !tap || !tap->wants || tap->wants(tap->ctx, frame, y);
}

/* True if it chooses rows. Then no file is written. */
static inline bool tap_chooses(const struct row_tap *tap)
{
    return tap && tap->wants;
}

/* True if any of the rows is to be drawn. */
static inline bool tap_wants_any(const struct row_tap *tap, uint32_t frame, unsigned y, unsigned rows)
{
    unsigned end = y + rows;

    while (y < end && !tap_wants(tap, frame, y))
        y++;
    return y < end;
}

/* Gives the tap the rows that it wants of a band that begins at row `y`, `length` bytes each. */
static inline void tap_rows(const struct row_tap *tap, uint32_t frame, unsigned y, unsigned rows,
                            const unsigned char *bytes, size_t length)
{
    for (unsigned i = 0; tap && i < rows; i++)
        if (tap_wants(tap, frame, y + i))
            tap->row(tap->ctx, frame, y + i, bytes + i * length, length);
}

#endif
