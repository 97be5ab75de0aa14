#include "row_hashes.h"

#include <stdlib.h>

#include <tia/debug.h>

#include "common/crc_join.h"

enum { ROWS_MOST = 1 << 26 };

struct row_hash {
    unsigned char hash[SHA256_BYTES];
    uint32_t crc;
    bool has;
};

bool row_hashes_begin(struct row_hashes *h, const struct image_film *film)
{
    uint64_t rows = (uint64_t)film->rows * film->frames;

    *h = (struct row_hashes){.film = *film};
    h->rows = rows <= ROWS_MOST ? calloc((size_t)rows + 1, sizeof *h->rows) : NULL;
    return h->rows;
}

void row_hashes_end(struct row_hashes *h)
{
    free(h->rows);
    h->rows = NULL;
}

/* Returns the CRC-32 of bytes. tia_crc32 takes pairs of bytes; a last single one is added bit by bit. */
static uint32_t crc_of(const unsigned char *bytes, size_t length)
{
    tia_rgb565 pairs[256];
    uint32_t crc = 0;

    while (length > 1) {
        size_t count = length / 2 < 256 ? length / 2 : 256;
        for (size_t i = 0; i < count; i++)
            pairs[i] = (tia_rgb565)(bytes[2 * i] | bytes[2 * i + 1] << 8);
        crc = tia_crc32(crc, pairs, count);
        bytes += 2 * count;
        length -= 2 * count;
    }
    if (!length)
        return crc;
    crc = ~crc ^ *bytes;
    for (unsigned i = 0; i < 8; i++)
        crc = crc >> 1 ^ (crc & 1u ? 0xedb88320u : 0u);
    return ~crc;
}

static struct row_hash *find(const struct row_hashes *h, uint32_t frame, unsigned y)
{
    const struct image_film *film = &h->film;
    uint32_t number = frame - film->first_frame;

    if (frame < film->first_frame || number >= film->frames || y < film->first_row || y - film->first_row >= film->rows)
        return NULL;
    return &h->rows[(size_t)number * film->rows + (y - film->first_row)];
}

void row_hashes_add(struct row_hashes *h, uint32_t frame, unsigned y, const unsigned char *bytes, size_t length)
{
    struct row_hash *row = find(h, frame, y);
    struct sha256 sha;

    if (!row)
        return;
    sha256_begin(&sha);
    sha256_add(&sha, bytes, length);
    sha256_end(&sha, row->hash);
    row->crc = crc_of(bytes, length);
    row->has = true;
    h->row_bytes = length;
}

static void add_number(struct sha256 *sha, uint32_t number)
{
    const unsigned char bytes[4] = {(unsigned char)(number & 255), (unsigned char)(number >> 8 & 255),
                                    (unsigned char)(number >> 16 & 255), (unsigned char)(number >> 24)};

    sha256_add(sha, bytes, sizeof bytes);
}

bool row_hashes_group(const struct row_hashes *h, struct record_group *group)
{
    struct sha256 sha;

    sha256_begin(&sha);
    sha256_add(&sha, &(unsigned char){0}, 1);
    add_number(&sha, group->frame);
    add_number(&sha, group->first);
    add_number(&sha, group->count);
    group->crc = 0;
    for (unsigned i = 0; i < group->count; i++) {
        const struct row_hash *row = find(h, group->frame, group->first + i);
        if (!row || !row->has)
            return false;
        sha256_add(&sha, row->hash, sizeof row->hash);
        group->crc = crc_join(group->crc, row->crc, h->row_bytes);
    }
    sha256_end(&sha, group->hash);
    return true;
}

uint32_t row_hashes_frame(const struct row_hashes *h, const struct record *record, uint32_t index)
{
    unsigned each = record_frame_groups(&record->film);
    uint32_t crc = 0;

    for (unsigned i = 0; i < each; i++) {
        const struct record_group *group = &record->groups[(size_t)index * each + i];
        crc = crc_join(crc, group->crc, (uint64_t)group->count * h->row_bytes);
    }
    return crc;
}
