/* checksum.h - checksums of bytes. */
#ifndef TOOLS_CHECKSUM_H
#define TOOLS_CHECKSUM_H

#include <stddef.h>
#include <stdint.h>

/* Returns the CRC-32 of the length (64 bits) and the bytes, continued from `crc`, which is 0 at first. */
uint32_t checksum_bytes(uint32_t crc, const void *bytes, size_t length);

#endif
