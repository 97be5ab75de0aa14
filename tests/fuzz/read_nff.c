/* read_nff.c - any bytes as a .nff file. */
#include "read.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    read_any(TIA_FORMAT_NFF, data, size);
    return 0;
}
