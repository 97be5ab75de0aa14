/* read_obj.c - any bytes as a .obj file. */
#include "read.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    read_any(TIA_FORMAT_OBJ, data, size);
    return 0;
}
