/* row_hashes.h - hashes of the rows of a picture, which may come in any order, and from them the groups of a record. */
#ifndef TOOLS_RECORD_ROW_HASHES_H
#define TOOLS_RECORD_ROW_HASHES_H

#include "record.h"

struct row_hash;

struct row_hashes {
    struct image_film film;
    struct row_hash *rows; /* of all frames in the film */
    size_t row_bytes;      /* bytes of each row */
};

/* Begins a film without rows. False: no memory, or too many rows. */
bool row_hashes_begin(struct row_hashes *hashes, const struct image_film *film);
void row_hashes_end(struct row_hashes *hashes);

/* Adds a row; those outside the film are ignored. All rows have the same length. */
void row_hashes_add(struct row_hashes *hashes, uint32_t frame, unsigned y, const unsigned char *bytes, size_t length);

/* Computes the CRC-32 and the hash of a group with the given place. False: one of its rows is missing. */
bool row_hashes_group(const struct row_hashes *hashes, struct record_group *group);

/* Returns the CRC-32 of all rows of frame number `index` of record->frames, from those of its groups. */
uint32_t row_hashes_frame(const struct row_hashes *hashes, const struct record *record, uint32_t index);

#endif
