#include "window_title.h"

#include <stdio.h>
#include <string.h>

bool title_is_shown(const char *term)
{
    static const char *const without[] = {"dumb", "linux", "vt"};

    for (size_t i = 0; i < sizeof without / sizeof without[0]; i++)
        if (!term || !*term || strncmp(term, without[i], strlen(without[i])) == 0)
            return false;
    return true;
}

void title_sequence(char sequence[TITLE_SIZE], const char *title)
{
    (void)snprintf(sequence, TITLE_SIZE, "\033]2;%.*s\033\\", TITLE_SIZE - 8, title);
}
