/* read_tia.c - any bytes as a .tia file. */
#include "read.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    read_any(TIA_FORMAT_TIA, data, size);
    return 0;
}
