#include "window_title.h"

#include <stdio.h>
#include <string.h>

#include "terminal_colour.h"

bool title_is_shown(const char *term)
{
    return !terminal_is_dumb(term) && !terminal_is_dec(term) && strncmp(term, "linux", 5) != 0;
}

void title_sequence(char sequence[TITLE_SIZE], const char *title)
{
    (void)snprintf(sequence, TITLE_SIZE, "\033]2;%.*s\033\\", TITLE_SIZE - 8, title);
}
