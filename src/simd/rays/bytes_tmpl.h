/* bytes_tmpl.h - bytes of lanes, side by side in one integer.
 *
 * Parameters: the doubles of isa/isa.h. Defines: grid_bytes(), numbers_of_bytes(), any_empty_byte(), bytes_of_lanes(),
 * lanes_of_bytes(). */
#ifndef TIA_SIMD_RAYS_BYTES_TMPL_H
#define TIA_SIMD_RAYS_BYTES_TMPL_H

#include "vector_tmpl.h"

/* Returns the bytes at these indices, a byte for each lane. */
LANE_OP uint64_t grid_bytes(const uint8_t *cells, vd index)
{
    int64_t at[LANES];
    vi words = whole_words(index);
    uint64_t content = 0;

    __builtin_memcpy(at, &words, sizeof at);
    for (int k = 0; k < LANES; k++)
        content |= (uint64_t)cells[at[k]] << 8 * k;
    return content;
}

/* Returns the bytes as numbers, one for each lane. */
LANE_OP vd numbers_of_bytes(uint64_t bytes)
{
#ifdef VBYTES
    return VBYTES(bytes);
#else
#define NUMBER(k) (double)(bytes >> 8 * (k)&255)
    return (vd){EACH_LANE(NUMBER)};
#undef NUMBER
#endif
}

/* True if a byte of `live`, whose bytes are 0 or 255, is 0. It may be true for a byte of 1 beside such a byte. */
LANE_OP bool any_empty_byte(uint64_t bytes, uint64_t live)
{
    return ((bytes - UINT64_C(0x0101010101010101)) & ~bytes & UINT64_C(0x8080808080808080) & live) != 0;
}

LANE_OP uint64_t bytes_of_lanes(unsigned lanes)
{
    uint64_t bytes = 0;

    for (int k = 0; k < LANES; k++)
        bytes |= (uint64_t)(lanes >> k & 1 ? 255 : 0) << 8 * k;
    return bytes;
}

/* Returns the lanes whose byte is not 0. */
LANE_OP unsigned lanes_of_bytes(uint64_t bytes)
{
    unsigned lanes = 0;

    for (int k = 0; k < LANES; k++)
        lanes |= (unsigned)((bytes >> 8 * k & 255) != 0) << k;
    return lanes;
}

#endif
