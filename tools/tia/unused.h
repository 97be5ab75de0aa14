/* unused.h - an unused name for a picture. */
#ifndef TOOLS_TIA_UNUSED_H
#define TOOLS_TIA_UNUSED_H

#include "common/signals.h"

struct unused {
    char path[32];
    struct signals_cleanup cleanup;
};

/* Creates the first of tia.png, tia-1.png, ... (or with another extension) that does not exist, as an empty file, so
 * that no other run uses its name. False, with errno, if none could be created. */
bool unused_create(struct unused *unused, const char *extension);

/* Removes the file if it is still empty. */
void unused_end(struct unused *unused);

#endif
