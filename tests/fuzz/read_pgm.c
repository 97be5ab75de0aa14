/* read_pgm.c - any bytes as a .pgm file. */
#include "read.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    read_any(TIA_FORMAT_PGM, data, size);
    return 0;
}
