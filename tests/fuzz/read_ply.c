/* read_ply.c - any bytes as a .ply file. */
#include "read.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    read_any(TIA_FORMAT_PLY, data, size);
    return 0;
}
