/* read_stl.c - any bytes as a .stl file. */
#include "read.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    read_any(TIA_FORMAT_STL, data, size);
    return 0;
}
