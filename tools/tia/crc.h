/* crc.h - the CRC-32 of two pieces of data from the CRC-32s of each. */
#ifndef TOOLS_TIA_CRC_H
#define TOOLS_TIA_CRC_H

#include <stdint.h>

/* Of the piece with `first`, followed by the piece of `bytes` bytes with `second`. */
uint32_t crc_join(uint32_t first, uint32_t second, uint64_t bytes);

#endif
