/* message_clean.c - apart from message.c, whose errno WebAssembly's modules do without. */
#include "message.h"

void message_clean(char *text)
{
    for (char *at = text; *at != '\0'; at++)
        if ((unsigned char)*at < ' ' || *at == 127)
            *at = '?';
}
