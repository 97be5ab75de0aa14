/* crc_join.h - combines the CRC-32s of two pieces of data. */
#ifndef TOOLS_COMMON_CRC_JOIN_H
#define TOOLS_COMMON_CRC_JOIN_H

#include <stdint.h>

/* Returns the CRC of data with the CRC `first`, followed by `bytes` bytes with the CRC `second`. */
uint32_t crc_join(uint32_t first, uint32_t second, uint64_t bytes);

#endif
