/* read_off.c - any bytes as a .off file. */
#include "read.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    read_any(TIA_FORMAT_OFF, data, size);
    return 0;
}
