/* ways.h - the ways of showing pictures that a user can name. */
#ifndef PORT_TERMINAL_WAYS_H
#define PORT_TERMINAL_WAYS_H

#include <stdbool.h>

#include "answers.h"
#include "terminal_colour.h"

#define WAYS_NAMES "automatic, halfblocks, symbols, sixel or kitty"

/* A way to show pictures. Zero is automatic: the best that the terminal reports. */
struct way {
    bool chosen;
    enum pictures pictures; /* the chosen kind, if any */
};

/* True if `name` (NULL: not given) is one of WAYS_NAMES; it is then stored in `way`. */
bool ways_find(const char *name, struct way *way);

/* Returns the name of the format for struct tia_mode; `colours` are those of characters. */
const char *ways_format(enum pictures pictures, enum colours colours);

#endif
