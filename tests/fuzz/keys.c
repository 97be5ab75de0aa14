/* keys.c - a terminal's bytes, one by one with pauses: the results are keys of tia/port.h, positions of a mouse or
 * Ctrl-Z, and silence ends every sequence but a paste. */
#include <stdio.h>

#include "bytes.h"
#include "terminal/key_decoder.h"

static void must_be_key(uint16_t key)
{
    MUST(key == DECODED_POINTER || key == DECODED_STOP || (key <= TIA_KEY_OTHER && (key < 128 || key >= TIA_KEY_LEFT)));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct decoder decoder = {0};

    for (size_t i = 0; i < size; i++) {
        must_be_key(decode_byte(&decoder, data[i]));
        if (decode_pending(&decoder) && data[i] % 16 == 5)
            must_be_key(decode_silence(&decoder));
    }
    if (decode_pending(&decoder)) {
        must_be_key(decode_silence(&decoder));
        MUST(!decode_pending(&decoder));
    }
    return 0;
}
