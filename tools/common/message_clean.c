/* message_clean.c - apart from message.c, whose errno WebAssembly's modules do without. */
#include "message.h"

void message_clean(char *text)
{
    for (char *at = text; *at != '\0'; at++)
        if ((unsigned char)*at < ' ' || *at == 127)
            *at = '?';
        else if ((unsigned char)at[0] == 0xc2 && (unsigned char)at[1] >= 0x80 && (unsigned char)at[1] < 0xa0)
            at[0] = at[1] = '?'; /* U+0080 to U+009F are control characters too */
}
