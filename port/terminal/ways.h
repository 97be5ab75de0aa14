/* ways.h - the ways of showing pictures that a user can name. */
#ifndef PORT_TERMINAL_WAYS_H
#define PORT_TERMINAL_WAYS_H

#include <stdbool.h>

#include "answers.h"

#define WAYS_NAMES "automatic, halfblocks, symbols, sixel or kitty"

/* Zero is automatic: the best that the terminal has, as it says itself. */
struct way {
    bool chosen;
    enum pictures pictures; /* if chosen */
};

/* Whether `name` (NULL: not given) is one of WAYS_NAMES, which then is stored in `way`. */
bool ways_find(const char *name, struct way *way);

/* What is shown, for the mode's format; `direct`: characters have 24-bit colours. */
const char *ways_format(enum pictures pictures, bool direct);

#endif
